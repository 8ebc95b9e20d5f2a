import { landscape, polynomial } from "./kit/landscape";

const height = polynomial([0, 0, 1 / 2, -1 / 3]);
export default landscape(() => height, 1.4, 1.7);
