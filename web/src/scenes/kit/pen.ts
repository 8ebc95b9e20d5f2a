// Draws the shapes of flat scenes as an engraver would: lines of ink, one colour for what moves.

import type { Ink } from "../../draw/ink";
import type { Look } from "../../lab/result";

export class Pen {
  readonly #pen: CanvasRenderingContext2D;
  readonly #scale: number;
  readonly #w: number;
  readonly #h: number;
  readonly ink: Ink;

  constructor(pen: CanvasRenderingContext2D, w: number, h: number, reach: number, ink: Ink) {
    this.#pen = pen;
    this.#w = w;
    this.#h = h;
    this.#scale = Math.min(w, h) / 2 / (reach * 1.15 || 1);
    this.ink = ink;
    pen.lineCap = "round";
    pen.lineJoin = "round";
  }

  x(x: number): number {
    return this.#w / 2 + x * this.#scale;
  }
  y(y: number): number {
    return this.#h / 2 - y * this.#scale;
  }
  /** From pixels to lengths. */
  place(px: number, py: number): [number, number] {
    return [(px - this.#w / 2) / this.#scale, (this.#h / 2 - py) / this.#scale];
  }

  line(points: [number, number][], width = 1.5, colour = this.ink.ink, dash: number[] = []): void {
    const pen = this.#pen;
    pen.beginPath();
    for (const [x, y] of points) pen.lineTo(this.x(x), this.y(y));
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.setLineDash(dash);
    pen.stroke();
    pen.setLineDash([]);
  }

  /** A ball, shaded by a lighter spot; the radius is in pixels. */
  ball(x: number, y: number, radius: number, colour = this.ink.ink): void {
    const pen = this.#pen;
    pen.beginPath();
    pen.arc(this.x(x), this.y(y), radius, 0, 2 * Math.PI);
    pen.fillStyle = colour;
    pen.fill();
    pen.beginPath();
    pen.arc(this.x(x) - radius * 0.3, this.y(y) - radius * 0.3, radius * 0.28, 0, 2 * Math.PI);
    pen.fillStyle = "rgb(255 255 255 / 0.45)";
    pen.fill();
  }

  circle(x: number, y: number, radius: number, colour = this.ink.faint, width = 1): void {
    const pen = this.#pen;
    pen.beginPath();
    pen.arc(this.x(x), this.y(y), radius * this.#scale, 0, 2 * Math.PI);
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.stroke();
  }

  /** A wall or ceiling, hatched as in old plates. */
  ceiling(half: number, y: number): void {
    this.line(
      [
        [-half, y],
        [half, y],
      ],
      1.5,
    );
    const step = half / 8;
    for (let k = -8; k < 8; k++)
      this.line(
        [
          [k * step, y],
          [(k + 1) * step, y + step],
        ],
        0.7,
        this.ink.faint,
      );
  }

  box(x: number, y: number, half: number, fill: number): void {
    const pen = this.#pen;
    const [left, top, side] = [this.x(x - half), this.y(y + half), 2 * half * this.#scale];
    pen.fillStyle = this.ink.curves[0] ?? this.ink.ink;
    const height = side * Math.min(Math.max(fill, 0), 1);
    pen.fillRect(left, top + side - height, side, height);
    pen.beginPath();
    pen.moveTo(left, top);
    pen.lineTo(left, top + side);
    pen.lineTo(left + side, top + side);
    pen.lineTo(left + side, top);
    pen.strokeStyle = this.ink.ink;
    pen.lineWidth = 1.8;
    pen.stroke();
  }

  /** The path up to a sample, fading with its age. */
  trail(
    look: Look,
    xs: (k: number) => number,
    ys: (k: number) => number,
    sample: number,
    colour = this.ink.accent,
  ): void {
    const pen = this.#pen;
    const PARTS = 24;
    const from = Math.max(0, sample - Math.ceil(look.times.length / 3));
    const step = Math.max(1, Math.floor((sample - from) / PARTS));
    pen.strokeStyle = colour;
    pen.lineWidth = 1.4;
    for (let a = from; a < sample; a += step) {
      const b = Math.min(a + step, sample);
      pen.globalAlpha = 0.12 + 0.88 * ((b - from) / Math.max(sample - from, 1)) ** 1.5;
      pen.beginPath();
      for (let k = a; k <= b; k++) pen.lineTo(this.x(xs(k)), this.y(ys(k)));
      pen.stroke();
    }
    pen.globalAlpha = 1;
  }

  /** A mass seen from above: where it came from, the thread to the centre, the mass. */
  bob(look: Look, sample: number, radius: number, width: number, thread = this.ink.ink): void {
    const at = (k: number): [number, number] => [look.at("x", k), look.at("y", k)];
    this.trail(
      look,
      (k) => at(k)[0],
      (k) => at(k)[1],
      sample,
    );
    this.line([[0, 0], at(sample)], width, thread);
    this.ball(...at(sample), radius);
  }

  /** The centre of a figure: two thin lines, `half` long to each side. */
  cross(half: number, width: number, dash: number[] = []): void {
    for (const [x, y] of [
      [half, 0],
      [0, half],
    ] as const)
      this.line(
        [
          [-x, -y],
          [x, y],
        ],
        width,
        this.ink.faint,
        dash,
      );
  }
}
