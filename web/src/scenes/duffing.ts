import { landscape, polynomial } from "./kit/landscape";

export default landscape((look) =>
  polynomial([0, 0, look.parameter("alpha") / 2, 0, look.parameter("beta") / 4]),
);
