// Events in a graph: lines across time with names where there is room, rings on a curve.

import type { Mark } from "../lab/marks";
import type { Ink } from "./ink";
import { px, py, type Frame, type Plot } from "./plot";
import type { Brush } from "./svg";

/** More than these are small marks below. */
const FEW = 40;

export function drawEvents(pen: Brush, f: Frame, plot: Plot, marks: readonly Mark[], ink: Ink): void {
  const lead = plot.curves[0];
  if (!lead) return;
  pen.strokeStyle = ink.faint;
  pen.fillStyle = ink.faint;
  pen.lineWidth = ink.weight;
  const many = marks.length > FEW;
  if (plot.x !== "t" && !plot.x.startsWith("t ")) {
    if (many) return;
    pen.setLineDash([]);
    for (const { sample } of marks) {
      const [x, y] = [px(f, lead.x[sample] ?? NaN), py(f, lead.y[sample] ?? NaN)];
      if (!Number.isFinite(x) || !Number.isFinite(y)) continue;
      pen.beginPath();
      pen.arc(x, y, 3.5, 0, 2 * Math.PI);
      pen.stroke();
    }
    return;
  }
  pen.setLineDash(many ? [] : [2, 3]);
  pen.textAlign = "left";
  let drawn = -Infinity;
  /** Where the last name ends, in each of the two lines of names. */
  const ends = [-Infinity, -Infinity];
  for (const { t, name } of marks) {
    const x = Math.round(px(f, t)) + 0.5;
    if (x < f.left || x > f.right || x === drawn) continue;
    drawn = x;
    pen.beginPath();
    pen.moveTo(x, many ? f.bottom - 6 : f.top);
    pen.lineTo(x, f.bottom);
    pen.stroke();
    const width = pen.measureText(name).width + 6;
    const row = many ? -1 : ends.findIndex((end) => end < x);
    if (row < 0 || x + width > f.right) continue;
    ends[row] = x + width;
    pen.fillText(name, x + 3, f.bottom - 6 - 14 * row);
  }
  pen.setLineDash([]);
}
