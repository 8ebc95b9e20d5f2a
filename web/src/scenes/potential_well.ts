import { landscape, polynomial } from "./kit/landscape";

export default landscape((look) => polynomial(look.list("u").map(([c = 0]) => c)), 1.5, 3);
