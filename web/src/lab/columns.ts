// The numbers of a run, column after column: a view asks for columns, the core has rows.

import type { Run } from "../core";

export function columnsOf({ report: { rows, columns }, numbers: table }: Run): Float64Array {
  const numbers = new Float64Array(table.length);
  for (let row = 0; row < rows; row++) {
    for (let k = 0; k < columns.length; k++) {
      numbers[k * rows + row] = table[row * columns.length + k] ?? NaN;
    }
  }
  return numbers;
}
