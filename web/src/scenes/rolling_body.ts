import { onTable } from "./kit/table";

export default onTable();
