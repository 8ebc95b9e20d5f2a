// The colours of the page for what is drawn on canvases.

export interface Ink {
  paper: string;
  ink: string;
  faint: string;
  grid: string;
  accent: string;
  /** One colour a curve, in order; told apart by dashes too. */
  curves: string[];
  dark: boolean;
  font: string;
  /** How much stronger lines and letters are than usual. */
  weight: number;
}

export function inkOf(element: Element): Ink {
  const style = getComputedStyle(element);
  const colour = (name: string) => style.getPropertyValue(`--${name}`).trim();
  return {
    paper: colour("paper"),
    ink: colour("ink"),
    faint: colour("faint"),
    grid: colour("grid"),
    accent: colour("accent"),
    curves: ["curve1", "curve2", "curve3", "curve4", "curve5"].map(colour),
    dark: colour("dark") === "1",
    font: style.fontFamily,
    weight: Number(colour("weight")) || 1,
  };
}

export const DASHES = [[], [7, 3], [2, 3], [9, 3, 2, 3], [4, 4]] as const;

/** Makes a canvas as sharp as the screen; its context, in the page's pixels. */
export function prepare(
  canvas: HTMLCanvasElement,
): { pen: CanvasRenderingContext2D; w: number; h: number } | undefined {
  const pen = canvas.getContext("2d");
  const { clientWidth: w, clientHeight: h } = canvas;
  if (!pen || w === 0 || h === 0) return undefined;
  const ratio = Math.min(devicePixelRatio, 3);
  const [width, height] = [Math.round(w * ratio), Math.round(h * ratio)];
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, w, h);
  return { pen, w, h };
}
