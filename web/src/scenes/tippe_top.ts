import { onTable, supportOf } from "./kit/table";
import { tippe } from "./kit/tippe";

export default onTable((look) => {
  const { point, radius } = supportOf(look);
  return tippe(radius, point[2]);
});
