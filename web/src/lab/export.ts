// What a run can be taken away as.

import { Look } from "./result";
import { exact, type Scenario } from "./scenario";

/** The samples as a table with names in the first line, as the command line writes it. */
export function csv(look: Look): string {
  const names = look.result.report.columns.map(({ name }) => name);
  const columns = names.map((name) => look.column(name));
  const rows = Array.from(look.times, (_, k) => columns.map((column) => exact(column[k] ?? NaN)).join(","));
  return `${[names.join(","), ...rows].join("\n")}\n`;
}

const OPTIONS = ["dt", "rtol", "atol", "until", "every"];

/** A word for a shell, in quotes where it needs them. */
function word(text: string): string {
  return /^[\w.,:/+=-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;
}

/** The command that makes the same run; a scenario that watches or draws something needs its file. */
export function command(scenario: Scenario, file = "scenario.toml"): string {
  if (scenario.rest) return `precess run ${file}`;
  const pair = (flag: string) => (entry: [string, string]) => [flag, word(entry.join("="))];
  const run = Object.entries(scenario.run);
  return [
    ...["precess", "run", scenario.system],
    ...Object.entries(scenario.parameters).flatMap(pair("-p")),
    ...Object.entries(scenario.start).flatMap(pair("-i")),
    ...(scenario.method ? ["--method", word(scenario.method)] : []),
    ...run.filter(([name]) => !OPTIONS.includes(name)).flatMap(pair("--option")),
    ...run.filter(([name]) => OPTIONS.includes(name)).flatMap(([name, text]) => [`--${name}`, word(text)]),
  ].join(" ");
}

/** Hands something to the browser as a file. */
export function download(name: string, blob: Blob): void {
  const url = URL.createObjectURL(blob);
  const anchor = document.createElement("a");
  anchor.href = url;
  anchor.download = name;
  anchor.click();
  setTimeout(() => {
    URL.revokeObjectURL(url);
  }, 10_000);
}
