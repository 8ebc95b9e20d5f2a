// Small crosses on a table that goes along with a body: they rest, so one sees that it moves.

import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from "three";

const [STEP, ARM, HALF] = [0.3, 0.018, 4];
const COUNT = (2 * HALF + 1) ** 2;

export class Crosses {
  readonly object: LineSegments;
  readonly #radius: number;
  readonly #points = new BufferAttribute(new Float32Array(COUNT * 12), 3);

  /** On a round table of some radius at some height. */
  constructor(radius: number, z: number, colour: string) {
    this.#radius = radius - 2 * ARM;
    const geometry = new BufferGeometry().setAttribute("position", this.#points);
    this.object = new LineSegments(geometry, new LineBasicMaterial({ color: colour }));
    this.object.position.z = z + 0.001;
    this.object.frustumCulled = false;
    this.show(0, 0);
  }

  /** With the middle of the table at a place. */
  show(x: number, y: number): void {
    const [i, j] = [Math.round(x / STEP), Math.round(y / STEP)];
    let at = 0;
    for (let a = -HALF; a <= HALF; a++)
      for (let b = -HALF; b <= HALF; b++) {
        const [px, py] = [(i + a) * STEP - x, (j + b) * STEP - y];
        // One that is not on the table has no size.
        const arm = Math.hypot(px, py) < this.#radius ? ARM : 0;
        for (const [dx, dy] of [
          [-arm, 0],
          [arm, 0],
          [0, -arm],
          [0, arm],
        ] as const)
          this.#points.setXYZ(at++, px + dx, py + dy, 0);
      }
    this.#points.needsUpdate = true;
  }
}
