// A graph on millimetre paper: curves of one quantity against another, and a mark at the sample shown.

import { shown, type Language } from "../lab/number";
import { DASHES, prepare, type Ink } from "./ink";
import type { Brush } from "./svg";
import { rangeOf, ticks } from "./ticks";

export interface Curve {
  x: Float64Array;
  y: Float64Array;
  colour: number;
  /** The first point that cannot be trusted: it and all beyond are grey. */
  horizon?: number;
}

export interface Plot {
  curves: Curve[];
  /** Points without lines: what was measured. */
  points?: Curve[];
  x: string;
  /** A name a curve, in its colour. */
  y: string[];
  equal: boolean;
}

/** Where things lie: from numbers to pixels and back. */
export interface Frame {
  left: number;
  top: number;
  right: number;
  bottom: number;
  x: [number, number];
  y: [number, number];
}

export const px = (f: Frame, x: number) => f.left + ((x - f.x[0]) / (f.x[1] - f.x[0])) * (f.right - f.left);
export const py = (f: Frame, y: number) => f.bottom - ((y - f.y[0]) / (f.y[1] - f.y[0])) * (f.bottom - f.top);
export const ux = (f: Frame, p: number) => f.x[0] + ((p - f.left) / (f.right - f.left)) * (f.x[1] - f.x[0]);
export const uy = (f: Frame, p: number) => f.y[0] + ((f.bottom - p) / (f.bottom - f.top)) * (f.y[1] - f.y[0]);

function frameOf(plot: Plot, w: number, h: number, top: number, snug: boolean): Frame {
  const [left, right, bottom] = [58, w - 12, h - 34];
  const all = [...plot.curves, ...(plot.points ?? [])];
  let x = rangeOf(all.map((curve) => curve.x));
  let y = rangeOf(all.map((curve) => curve.y));
  if (snug) {
    const air = ((x[1] - x[0]) * 0.05) / 1.1;
    x = [x[0] + air, x[1] - air];
  }
  if (plot.equal) {
    const scale = Math.max((x[1] - x[0]) / (right - left), (y[1] - y[0]) / (bottom - top));
    const widen = ([a, b]: [number, number], pixels: number): [number, number] => {
      const [middle, half] = [(a + b) / 2, (scale * pixels) / 2];
      return [middle - half, middle + half];
    };
    x = widen(x, right - left);
    y = widen(y, bottom - top);
  }
  return { left, top, right, bottom, x, y };
}

/** Draws all that does not move. */
export function drawPlot(
  { pen, w, h }: { pen: Brush; w: number; h: number },
  plot: Plot,
  ink: Ink,
  language: Language,
): Frame {
  const byTime = plot.x.startsWith("t ") || plot.x === "t";
  const letter = 12 * Math.min(ink.weight, 1.25);
  pen.font = `${letter}px ${ink.font}`;
  const names = inRows(pen, plot.y, w);
  const line = (row: number) => 13 + row * (letter + 3);
  // Below the names there is room for half of a number at the frame's upper end.
  const f = frameOf(plot, w, h, line(names.at(-1)?.row ?? 0) + 11, byTime);
  const across = ticks(f.x[0], f.x[1], (f.right - f.left) / 80);
  const up = ticks(f.y[0], f.y[1], (f.bottom - f.top) / 40);
  millimetres(pen, f, across, up, ink);
  pen.fillStyle = ink.faint;
  pen.textAlign = "center";
  for (const x of across) {
    const text = shown(x, language, 6);
    // The last one may not stand out of the picture.
    pen.fillText(text, Math.min(px(f, x), w - pen.measureText(text).width / 2), f.bottom + 14);
  }
  pen.textAlign = "right";
  for (const y of up) pen.fillText(shown(y, language, 6), f.left - 6, py(f, y) + 4, f.left - 8);
  pen.fillStyle = ink.ink;
  pen.fillText(plot.x, f.right, h - 6);
  pen.textAlign = "left";
  names.forEach(({ name, x, row }, k) => {
    pen.fillStyle = names.length > 1 ? (ink.curves[k % ink.curves.length] ?? ink.ink) : ink.ink;
    pen.fillText(name, x, line(row));
  });
  pen.save();
  pen.beginPath();
  pen.rect(f.left, f.top, f.right - f.left, f.bottom - f.top);
  pen.clip();
  pen.lineJoin = "round";
  if (byTime) shade(pen, f, plot, ink);
  for (const curve of plot.curves) {
    const horizon = Math.min(curve.horizon ?? Infinity, curve.x.length);
    pen.setLineDash([...(DASHES[curve.colour % DASHES.length] ?? [])]);
    pen.lineWidth = (curve.colour === 0 ? 1.6 : 1.3) * ink.weight;
    // Both parts meet in a point.
    pen.strokeStyle = ink.faint;
    pen.globalAlpha = 0.5;
    if (horizon < curve.x.length) trace(pen, f, curve, byTime, Math.max(horizon - 1, 0), curve.x.length);
    pen.globalAlpha = 1;
    pen.strokeStyle = ink.curves[curve.colour % ink.curves.length] ?? ink.ink;
    trace(pen, f, curve, byTime, 0, horizon);
  }
  pen.setLineDash([]);
  for (const { x, y, colour } of plot.points ?? []) {
    pen.strokeStyle = colour === 0 ? ink.accent : (ink.curves[colour % ink.curves.length] ?? ink.ink);
    pen.lineWidth = 1.2 * ink.weight;
    x.forEach((at, k) => {
      pen.beginPath();
      pen.arc(px(f, at), py(f, y[k] ?? NaN), 3, 0, 2 * Math.PI);
      pen.stroke();
    });
  }
  pen.restore();
  return f;
}

/** Names side by side; one that does not fit begins a row. */
function inRows(pen: Brush, names: readonly string[], w: number): { name: string; x: number; row: number }[] {
  let [x, row] = [6, 0];
  return names.map((name) => {
    const { width } = pen.measureText(name);
    if (x > 6 && x + width > w - 6) [x, row] = [6, row + 1];
    const place = { name, x, row };
    x += width + 12;
    return place;
  });
}

/** The time that cannot be trusted, greyed. */
function shade(pen: Brush, f: Frame, { curves }: Plot, ink: Ink): void {
  const doubted = curves.find(({ x, horizon = Infinity }) => horizon < x.length);
  if (!doubted) return;
  const from = px(f, doubted.x[Math.max((doubted.horizon ?? 0) - 1, 0)] ?? NaN);
  // A run may go backwards.
  const to = px(f, doubted.x.at(-1) ?? NaN);
  pen.fillStyle = ink.faint;
  pen.globalAlpha = 0.14;
  pen.fillRect(Math.min(from, to), f.top, Math.abs(to - from), f.bottom - f.top);
  pen.globalAlpha = 1;
}

function millimetres(pen: Brush, f: Frame, across: number[], up: number[], ink: Ink): void {
  pen.strokeStyle = ink.grid;
  const lines = (
    at: number[],
    draw: (p: number) => void,
    place: (x: number) => number,
    ends: [number, number],
  ) => {
    const [a = 0, b] = at;
    const width = Math.abs(ends[1] - ends[0]);
    const step = b === undefined ? width : Math.abs(place(b) - place(a)) || width;
    const fine = step / 5;
    const first = place(a);
    for (let k = -50; k < 250; k++) {
      const p = ends[0] < ends[1] ? first + k * fine : first - k * fine;
      if (p < Math.min(...ends) || p > Math.max(...ends)) continue;
      pen.lineWidth = k % 5 === 0 ? 1 : 0.4;
      draw(Math.round(p * 2) / 2);
    }
  };
  const line = (x0: number, y0: number, x1: number, y1: number) => {
    pen.beginPath();
    pen.moveTo(x0, y0);
    pen.lineTo(x1, y1);
    pen.stroke();
  };
  lines(
    across,
    (p) => {
      line(p, f.top, p, f.bottom);
    },
    (x) => px(f, x),
    [f.left, f.right],
  );
  lines(
    up,
    (p) => {
      line(f.left, p, f.right, p);
    },
    (y) => py(f, y),
    [f.bottom, f.top],
  );
  pen.strokeStyle = ink.ink;
  pen.lineWidth = 1;
  pen.strokeRect(f.left, f.top, f.right - f.left, f.bottom - f.top);
}

/** A curve against time is thinned to its lowest and highest point in each column of pixels. */
function trace(pen: Brush, f: Frame, { x, y }: Curve, byTime: boolean, from: number, to: number): void {
  const each = byTime ? Math.max(1, Math.floor(x.length / ((f.right - f.left) * 2))) : 1;
  pen.beginPath();
  let down = false;
  const go = (k: number) => {
    const [a, b] = [px(f, x[k] ?? NaN), py(f, y[k] ?? NaN)];
    if (!Number.isFinite(a) || !Number.isFinite(b)) {
      down = false;
      return;
    }
    if (down) pen.lineTo(a, b);
    else pen.moveTo(a, b);
    down = true;
  };
  for (let k = from; k < to; k += each) {
    if (each === 1) {
      go(k);
      continue;
    }
    let [low, high] = [k, k];
    for (let n = k; n < Math.min(k + each, to); n++) {
      if ((y[n] ?? 0) < (y[low] ?? 0)) low = n;
      if ((y[n] ?? 0) > (y[high] ?? 0)) high = n;
    }
    go(Math.min(low, high));
    if (low !== high) go(Math.max(low, high));
  }
  pen.stroke();
}

/** Draws what moves, on a canvas of its own. */
export function drawMark(canvas: HTMLCanvasElement, f: Frame, plot: Plot, sample: number, ink: Ink): void {
  const ready = prepare(canvas);
  if (!ready) return;
  const { pen } = ready;
  const byTime = plot.x.startsWith("t ") || plot.x === "t";
  const lead = plot.curves[0];
  if (!lead) return;
  const x = px(f, lead.x[sample] ?? NaN);
  if (byTime) {
    pen.strokeStyle = ink.accent;
    pen.lineWidth = 1;
    pen.beginPath();
    pen.moveTo(x, f.top);
    pen.lineTo(x, f.bottom);
    pen.stroke();
  }
  for (const curve of plot.curves) {
    const [a, b] = [px(f, curve.x[sample] ?? NaN), py(f, curve.y[sample] ?? NaN)];
    if (!Number.isFinite(a) || !Number.isFinite(b)) continue;
    pen.fillStyle =
      curve.colour === 0 ? ink.accent : (ink.curves[curve.colour % ink.curves.length] ?? ink.ink);
    pen.beginPath();
    pen.arc(a, b, 4, 0, 2 * Math.PI);
    pen.fill();
  }
}
