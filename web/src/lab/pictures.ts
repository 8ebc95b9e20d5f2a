// The scene and the graphs as pictures to take away.

import type { Ink } from "../draw/ink";
import { drawEvents } from "../draw/marks";
import { drawPlot, type Plot } from "../draw/plot";
import { SvgBrush, sheet } from "../draw/svg";
import { Pen } from "../scenes/kit/pen";
import type { Flat } from "../scenes/kit/scene";
import { marksOf } from "./marks";
import type { Language } from "./number";
import type { Look } from "./result";

export { download } from "./export";

/** What is on a canvas, on paper. */
export function png(canvas: HTMLCanvasElement, paper: string): Promise<Blob> {
  const copy = document.createElement("canvas");
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const pen = copy.getContext("2d");
  if (pen) {
    pen.fillStyle = paper;
    pen.fillRect(0, 0, copy.width, copy.height);
    pen.drawImage(canvas, 0, 0);
  }
  return new Promise((resolve, reject) => {
    copy.toBlob((blob) => {
      if (blob) resolve(blob);
      else reject(new Error("no picture"));
    }, "image/png");
  });
}

const [WIDTH, HEIGHT] = [720, 420];

/** A flat scene at a sample, as SVG. */
export function flatSvg(scene: Flat, look: Look, sample: number, ink: Ink): string {
  const brush = new SvgBrush();
  scene.draw(new Pen(brush, WIDTH, HEIGHT, scene.reach(look), ink, scene.centre?.(look)), look, sample);
  return sheet(WIDTH, HEIGHT, ink.paper, [{ x: 0, y: 0, elements: brush.elements }]);
}

/** A graph as SVG. */
export function graphSvg(plot: Plot, ink: Ink, language: Language, look?: Look): string {
  const brush = new SvgBrush();
  const frame = drawPlot({ pen: brush, w: WIDTH, h: HEIGHT }, plot, ink, language);
  if (look) drawEvents(brush, frame, plot, marksOf(look, language), ink);
  return sheet(WIDTH, HEIGHT, ink.paper, [{ x: 0, y: 0, elements: brush.elements }]);
}
