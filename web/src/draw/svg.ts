// A brush that writes SVG instead of painting: what is drawn on a canvas can be taken away as a drawing.

/** What the drawings here ask of a canvas. */
export type Brush = Pick<
  CanvasRenderingContext2D,
  | "strokeStyle"
  | "fillStyle"
  | "lineWidth"
  | "lineCap"
  | "lineJoin"
  | "globalAlpha"
  | "font"
  | "textAlign"
  | "textBaseline"
  | "beginPath"
  | "moveTo"
  | "lineTo"
  | "arc"
  | "rect"
  | "stroke"
  | "fill"
  | "clip"
  | "save"
  | "restore"
  | "setLineDash"
  | "fillRect"
  | "strokeRect"
  | "fillText"
  | "measureText"
>;

const escaped = (text: string) =>
  text.replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c] ?? c);
const tidy = (x: number) => String(Math.round(x * 100) / 100);

export class SvgBrush implements Brush {
  strokeStyle = "#000";
  fillStyle = "#000";
  lineWidth = 1;
  lineCap: CanvasLineCap = "butt";
  lineJoin: CanvasLineJoin = "miter";
  globalAlpha = 1;
  font = "12px sans-serif";
  textAlign: CanvasTextAlign = "left";
  textBaseline: CanvasTextBaseline = "alphabetic";

  #path = "";
  #dash: readonly number[] = [];
  #clips = 0;
  /** Groups that a clip has opened since the last `save`. */
  #open = 0;
  readonly #out: string[] = [];
  readonly #id: string;

  /** `id` tells the clips of several drawings on one sheet apart. */
  constructor(id = "clip") {
    this.#id = id;
  }

  beginPath(): void {
    this.#path = "";
  }
  moveTo(x: number, y: number): void {
    this.#path += `M${tidy(x)} ${tidy(y)}`;
  }
  /** As on a canvas, a first point is gone to, not drawn to. */
  lineTo(x: number, y: number): void {
    this.#path += `${this.#path ? "L" : "M"}${tidy(x)} ${tidy(y)}`;
  }
  /** Whole circles only: nothing else is drawn here. */
  arc(x: number, y: number, r: number): void {
    const [a, b, c] = [tidy(x + r), tidy(x - r), tidy(r)];
    this.#path += `M${a} ${tidy(y)}A${c} ${c} 0 1 1 ${b} ${tidy(y)}A${c} ${c} 0 1 1 ${a} ${tidy(y)}Z`;
  }
  rect(x: number, y: number, w: number, h: number): void {
    this.#path += `M${tidy(x)} ${tidy(y)}h${tidy(w)}v${tidy(h)}h${tidy(-w)}Z`;
  }

  #shape(fill: string, stroke: string): void {
    if (!this.#path) return;
    const alpha = this.globalAlpha < 1 ? ` opacity="${tidy(this.globalAlpha)}"` : "";
    const dash = stroke !== "none" && this.#dash.length ? ` stroke-dasharray="${this.#dash.join(" ")}"` : "";
    const line =
      stroke === "none"
        ? ""
        : ` stroke="${escaped(stroke)}" stroke-width="${tidy(this.lineWidth)}" stroke-linecap="${this.lineCap}" stroke-linejoin="${this.lineJoin}"`;
    this.#out.push(`<path d="${this.#path}" fill="${escaped(fill)}"${line}${dash}${alpha}/>`);
  }
  stroke(): void {
    this.#shape("none", this.strokeStyle);
  }
  fill(): void {
    this.#shape(this.fillStyle, "none");
  }
  fillRect(x: number, y: number, w: number, h: number): void {
    this.beginPath();
    this.rect(x, y, w, h);
    this.fill();
  }
  strokeRect(x: number, y: number, w: number, h: number): void {
    this.beginPath();
    this.rect(x, y, w, h);
    this.stroke();
  }
  clip(): void {
    const id = `${this.#id}${++this.#clips}`;
    this.#out.push(`<clipPath id="${id}"><path d="${this.#path}"/></clipPath><g clip-path="url(#${id})">`);
    this.#open++;
  }
  save(): void {
    this.restore();
  }
  restore(): void {
    this.#out.push("</g>".repeat(this.#open));
    this.#open = 0;
  }
  setLineDash(dash: Iterable<number>): void {
    this.#dash = [...dash];
  }

  fillText(text: string, x: number, y: number): void {
    const anchor = { center: "middle", right: "end", end: "end", left: "start", start: "start" }[
      this.textAlign
    ];
    const middle = this.textBaseline === "middle" ? ' dominant-baseline="central"' : "";
    this.#out.push(
      `<text x="${tidy(x)}" y="${tidy(y)}" text-anchor="${anchor}"${middle} fill="${escaped(this.fillStyle)}" style="font:${escaped(this.font)}">${escaped(text)}</text>`,
    );
  }
  /** Roughly: letters of an unknown font are half as wide as high. */
  measureText(text: string): TextMetrics {
    return {
      width: text.length * 0.55 * (parseFloat(/[\d.]+px/.exec(this.font)?.[0] ?? "12") || 12),
    } as TextMetrics;
  }

  /** What has been drawn, as elements. */
  get elements(): string {
    return this.#out.join("\n");
  }
}

/** A sheet with drawings on it, each moved to its place. */
export function sheet(
  width: number,
  height: number,
  paper: string,
  drawings: { x: number; y: number; elements: string }[],
): string {
  const groups = drawings.map(
    ({ x, y, elements }) => `<g transform="translate(${tidy(x)} ${tidy(y)})">\n${elements}\n</g>`,
  );
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${tidy(width)}" height="${tidy(height)}" viewBox="0 0 ${tidy(width)} ${tidy(height)}">`,
    `<rect width="100%" height="100%" fill="${escaped(paper)}"/>`,
    ...groups,
    "</svg>",
    "",
  ].join("\n");
}
