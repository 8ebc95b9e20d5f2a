// Vectors as arrows in a solid scene; each as long as the scene where it is largest.

import type { Look } from "../../lab/result";
import type { Place } from "./scene";
import { CylinderGeometry, Group, Mesh, MeshBasicMaterial, Vector3 } from "./studio";
import { largest, type Vector } from "./vectors";

const [SHAFT, HEAD, TIP] = [0.012, 0.036, 0.11];
const UP = new Vector3(0, 1, 0);

interface Arrow {
  vector: Vector;
  /** Picture lengths of a unit of it. */
  scale: number;
  group: Group;
  shaft: Mesh;
  head: Mesh;
}

export class Arrows {
  readonly object = new Group();
  readonly #arrows: Arrow[];
  readonly #size: number;

  /** `size` is what the scene is scaled by, `reach` how long the longest arrow is, in the scene's lengths. */
  constructor(
    vectors: readonly Vector[],
    look: Look,
    { size, reach, colours }: { size: number; reach: number; colours: (name: Vector["name"]) => string },
  ) {
    this.#size = size;
    this.#arrows = vectors.map((vector) => {
      const color = colours(vector.name);
      const part = (top: number, bottom: number, height: number) => {
        const shape = new CylinderGeometry(top, bottom, height, 16);
        // What is within the body or under the table shines through.
        const ghost = { color, transparent: true, opacity: 0.3, depthTest: false };
        const mesh = new Mesh(shape, new MeshBasicMaterial({ color }));
        return mesh.add(new Mesh(shape, new MeshBasicMaterial(ghost)));
      };
      const [shaft, head] = [part(SHAFT, SHAFT, 1), part(0, HEAD, TIP)];
      const group = new Group();
      group.add(shaft, head);
      this.object.add(group);
      // A weight of full length would only hide what is below.
      const share = vector.name === "weight" ? 0.5 : 1;
      return { vector, scale: (share * reach) / size / (largest(vector, look) || 1), group, shaft, head };
    });
  }

  show(sample: number): void {
    const placed = (place: Place) => new Vector3(...place).divideScalar(this.#size);
    for (const { vector, scale, group, shaft, head } of this.#arrows) {
      const by = new Vector3(...vector.by(sample)).multiplyScalar(scale);
      const length = by.length();
      group.visible = length > 0.02;
      if (!group.visible) continue;
      group.position.copy(placed(vector.from(sample)));
      group.quaternion.setFromUnitVectors(UP, by.normalize());
      // A short arrow has a small head.
      const tip = Math.min(TIP, length * 0.6);
      shaft.scale.y = length - tip;
      shaft.position.y = (length - tip) / 2;
      head.scale.setScalar(tip / TIP);
      head.position.y = length - tip / 2;
    }
  }
}
