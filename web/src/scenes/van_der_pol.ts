import { recorder } from "./kit/recorder";

/** Between the marks the motion is fed, beyond them damped. */
export default recorder("x", 0.4, (pen, look, _sample, r, top) => {
  const edge = look.parameter("x0");
  pen.area(
    [
      [-edge, top],
      [edge, top],
      [edge, -1.1 * r],
      [-edge, -1.1 * r],
    ],
    pen.ink.curves[2],
    0.1,
  );
  for (const x of [-edge, edge])
    pen.line(
      [
        [x, top + 0.08 * r],
        [x, top - 0.08 * r],
      ],
      2,
      pen.ink.curves[2],
    );
});
