import type { Solid } from "./kit/scene";
import { path } from "./kit/usual";

/** Seen from the side on which the wings open. */
const scene: Solid = { ...path, from: { round: 0.3, up: 0.18 } };
export default scene;
