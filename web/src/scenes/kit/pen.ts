// Draws the shapes of flat scenes as an engraver would: lines of ink, one colour for what moves.

import type { Ink } from "../../draw/ink";
import type { Brush } from "../../draw/svg";
import type { Look } from "../../lab/result";
import type { Window } from "../../lab/window";

export type Point = [x: number, y: number];

export class Pen {
  readonly #pen: Brush;
  readonly #scale: number;
  readonly #w: number;
  readonly #h: number;
  readonly #centre: Point;
  readonly ink: Ink;

  constructor(pen: Brush, w: number, h: number, reach: number | Point, ink: Ink, centre: Point = [0, 0]) {
    this.#pen = pen;
    this.#w = w;
    this.#h = h;
    const [across, up] = typeof reach === "number" ? [reach, reach] : reach;
    this.#scale = Math.min(w / (across || 1), h / (up || 1)) / 2.3;
    this.#centre = centre;
    this.ink = ink;
    pen.lineCap = "round";
    pen.lineJoin = "round";
  }

  x(x: number): number {
    return this.#w / 2 + (x - this.#centre[0]) * this.#scale;
  }
  y(y: number): number {
    return this.#h / 2 - (y - this.#centre[1]) * this.#scale;
  }
  /** From pixels to lengths. */
  place(px: number, py: number): Point {
    return [
      (px - this.#w / 2) / this.#scale + this.#centre[0],
      (this.#h / 2 - py) / this.#scale + this.#centre[1],
    ];
  }
  /** What the picture shows. */
  get window(): Window {
    return { centre: this.#centre, half: [this.#w / 2 / this.#scale, this.#h / 2 / this.#scale] };
  }
  /** How far the picture reaches to each side. */
  get half(): number {
    return this.#w / 2 / this.#scale;
  }

  #path(points: readonly Point[]): void {
    this.#pen.beginPath();
    for (const [x, y] of points) this.#pen.lineTo(this.x(x), this.y(y));
  }

  line(points: readonly Point[], width = 1.5, colour = this.ink.ink, dash: number[] = []): void {
    const pen = this.#pen;
    this.#path(points);
    pen.strokeStyle = colour;
    pen.lineWidth = width * this.ink.weight;
    pen.setLineDash(dash);
    pen.stroke();
    pen.setLineDash([]);
  }

  /** A surface, as strong as `alpha` says. */
  area(points: readonly Point[], colour = this.ink.ink, alpha = 1): void {
    const pen = this.#pen;
    this.#path(points);
    pen.globalAlpha = alpha;
    pen.fillStyle = colour;
    pen.fill();
    pen.globalAlpha = 1;
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

  /** A point, whose radius is in pixels. */
  dot(x: number, y: number, radius: number, colour = this.ink.ink): void {
    this.#pen.beginPath();
    this.#pen.arc(this.x(x), this.y(y), radius * this.ink.weight, 0, 2 * Math.PI);
    this.#pen.fillStyle = colour;
    this.#pen.fill();
  }

  circle(x: number, y: number, radius: number, colour = this.ink.faint, width = 1): void {
    const pen = this.#pen;
    pen.beginPath();
    pen.arc(this.x(x), this.y(y), radius * this.#scale, 0, 2 * Math.PI);
    pen.strokeStyle = colour;
    pen.lineWidth = width * this.ink.weight;
    pen.stroke();
  }

  /** An arrow from a point by a vector; none where that is shorter than a few pixels. */
  arrow([x, y]: Point, [dx, dy]: Point, colour = this.ink.accent, width = 2.5): void {
    const length = Math.hypot(dx, dy) * this.#scale;
    if (!(length > 3)) return;
    const head = Math.min(11, length * 0.6) / length;
    const [ux, uy] = [dx * head, dy * head];
    this.line(
      [
        [x, y],
        [x + dx - 0.7 * ux, y + dy - 0.7 * uy],
      ],
      width,
      colour,
    );
    this.area(
      [
        [x + dx, y + dy],
        [x + dx - ux - 0.45 * uy, y + dy - uy + 0.45 * ux],
        [x + dx - ux + 0.45 * uy, y + dy - uy - 0.45 * ux],
      ],
      colour,
    );
  }

  /** An arrow along a circle, by an angle from the upward direction, clockwise where it is positive. */
  turning([x, y]: Point, radius: number, from: number, angle: number, colour = this.ink.accent): void {
    const at = (a: number): Point => [x + radius * Math.sin(a), y + radius * Math.cos(a)];
    const steps = Array.from({ length: 33 }, (_, k) => at(from + (angle * k) / 32));
    this.line(steps, 2.5, colour);
    const [end, before] = [at(from + angle), at(from + angle - Math.sign(angle) * 0.2)];
    if (Math.abs(angle) > 0.1) this.arrow(before, [end[0] - before[0], end[1] - before[1]], colour);
  }

  /** A spring between two points. */
  spring([ax, ay]: Point, [bx, by]: Point, half: number, coils = 12): void {
    const length = Math.hypot(bx - ax, by - ay) || 1;
    const [ux, uy] = [(bx - ax) / length, (by - ay) / length];
    const at = (share: number, side: number): Point => [
      ax + (bx - ax) * share - uy * side * half,
      ay + (by - ay) * share + ux * side * half,
    ];
    const middle = Array.from({ length: 2 * coils }, (_, k) =>
      at(0.08 + (0.84 * (k + 0.5)) / (2 * coils), k % 2 ? 1 : -1),
    );
    this.line([[ax, ay], at(0.08, 0), ...middle, at(0.92, 0), [bx, by]], 1.6);
  }

  /** A wall or ceiling, hatched as in old plates; `side` says on which side of it one cannot be. */
  ceiling(half: number, y: number, x = 0, side: 1 | -1 = 1): void {
    this.line(
      [
        [x - half, y],
        [x + half, y],
      ],
      1.5,
    );
    const step = half / 8;
    for (let k = -8; k < 8; k++)
      this.line(
        [
          [x + k * step, y],
          [x + (k + 1) * step, y + side * step],
        ],
        0.7,
        this.ink.faint,
      );
  }
  wall(half: number, x: number, y = 0): void {
    this.line(
      [
        [x, y - half],
        [x, y + half],
      ],
      1.5,
    );
    const step = half / 8;
    for (let k = -8; k < 8; k++)
      this.line(
        [
          [x, y + k * step],
          [x - step, y + (k + 1) * step],
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

  /** A few letters beside a point. */
  letter(x: number, y: number, text: string, colour = this.ink.faint): void {
    const pen = this.#pen;
    pen.font = `italic ${15 * this.ink.weight}px ${this.ink.font}`;
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.fillStyle = colour;
    pen.fillText(text, this.x(x), this.y(y));
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
    pen.lineWidth = 1.4 * this.ink.weight;
    for (let a = from; a < sample; a += step) {
      const b = Math.min(a + step, sample);
      pen.globalAlpha = 0.12 + 0.88 * ((b - from) / Math.max(sample - from, 1)) ** 1.5;
      pen.beginPath();
      for (let k = a; k <= b; k++) pen.lineTo(this.x(xs(k)), this.y(ys(k)));
      pen.stroke();
    }
    pen.globalAlpha = 1;
  }
  /** The path of a point whose coordinates are two columns. */
  path(look: Look, x: string, y: string, sample: number, colour = this.ink.accent): void {
    this.trail(
      look,
      (k) => look.at(x, k),
      (k) => look.at(y, k),
      sample,
      colour,
    );
  }

  /** A mass seen from above: where it came from, the thread to the centre, the mass. */
  bob(look: Look, sample: number, radius: number, width: number, thread = this.ink.ink): void {
    this.path(look, "x", "y", sample);
    const at: Point = [look.at("x", sample), look.at("y", sample)];
    this.line([[0, 0], at], width, thread);
    this.ball(...at, radius);
  }

  /** The centre of a figure: two thin lines, `half` long to each side. */
  cross(half: number, width: number, dash: number[] = []): void {
    this.line(
      [
        [-half, 0],
        [half, 0],
      ],
      width,
      this.ink.faint,
      dash,
    );
    this.line(
      [
        [0, -half],
        [0, half],
      ],
      width,
      this.ink.faint,
      dash,
    );
  }
}
