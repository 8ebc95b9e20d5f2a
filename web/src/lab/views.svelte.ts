// Which part of a map is shown, and those that were shown before it.

import { between, moved, zoomed, type Pair, type Window } from "./window";

/** A wheel makes many of them: no more than anybody goes back. */
const KEPT = 50;

export class Views {
  #whole = $state.raw<Window>({ centre: [0, 0], half: [1, 1] });
  #closer = $state.raw<Window[]>([]);

  get now(): Window {
    return this.#closer.at(-1) ?? this.#whole;
  }
  /** Whether there is a view to go back to. */
  get deep(): boolean {
    return this.#closer.length > 0;
  }

  /** Another map. */
  begin(whole: Window): void {
    this.#whole = whole;
    this.#closer = [];
  }
  back(): void {
    this.#closer = this.#closer.slice(0, -1);
  }
  all(): void {
    this.#closer = [];
  }
  zoom(times: number, about: Pair = this.now.centre): void {
    this.#show(zoomed(this.now, times, about, this.#whole));
  }
  move(by: Pair): void {
    this.#show(moved(this.now, by));
  }
  /** The rectangle between two places. */
  frame(a: Pair, b: Pair): void {
    this.#show(between(this.now, a, b, this.#whole));
  }

  #show(next: Window): void {
    this.#closer = [...this.#closer.slice(-KEPT), next];
  }
}
