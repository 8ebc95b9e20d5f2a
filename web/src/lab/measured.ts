// Measured points from a CSV file, to be held against a run: names, then a line for each time, as `precess fit` reads them.

import type { Language } from "./number";

/** Its own words, which come with it. */
export const WORDS = {
  points: { en: "Measured points:", fr: "Points mesurés :" },
  forget: { en: "remove", fr: "retirer" },
  line: { en: "Line", fr: "Ligne" },
  noNumber: { en: "is no number", fr: "n'est pas un nombre" },
  noPoints: {
    en: "A table of measured points begins with names, one of them t, and then at least one of",
    fr: "Un tableau de points mesurés commence par des noms, dont t, puis au moins un de",
  },
};

export interface Measured {
  readonly file: string;
  readonly columns: ReadonlyMap<string, Float64Array>;
}

/** A file that cannot be shown; the message is for whoever opened it. */
export class Unreadable extends Error {}

/** Reads what a run has under the same names; a semicolon between the fields makes a comma a decimal one. */
export function measured(file: string, text: string, known: readonly string[], language: Language): Measured {
  const lines = text
    .replace(/^\ufeff/, "")
    .split(/\r?\n/)
    .map((line, k) => ({ line: line.trim(), number: k + 1 }))
    .filter(({ line }) => line && !line.startsWith("#"));
  const [head, ...body] = lines;
  const semicolons = head?.line.includes(";") ?? false;
  const fields = (line: string) => line.split(semicolons ? ";" : ",").map((field) => field.trim());
  // A unit may follow in brackets: `theta [rad]`.
  const names = fields(head?.line ?? "").map((name) => (name.split("[")[0] ?? "").replaceAll('"', "").trim());
  const shared = names.filter((name) => name !== "t" && known.includes(name));
  if (!names.includes("t") || !shared.length || !body.length) {
    throw new Unreadable(`${WORDS.noPoints[language]} ${known.join(", ")}`);
  }
  const columns = new Map(["t", ...shared].map((name) => [name, new Float64Array(body.length)]));
  body.forEach(({ line, number }, row) => {
    const values = fields(line);
    for (const [name, column] of columns) {
      const field = values[names.indexOf(name)] ?? "";
      const x = Number(semicolons ? field.replace(",", ".") : field);
      if (!field || !Number.isFinite(x)) {
        throw new Unreadable(
          `${WORDS.line[language]} ${number}: ${name} ${WORDS.noNumber[language]} ('${field}')`,
        );
      }
      column[row] = x;
    }
  });
  return { file, columns };
}
