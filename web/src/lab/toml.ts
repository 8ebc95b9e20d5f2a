// Reads the TOML that scenarios are written in, and keeps each value as the text a person would type. What it does
// not know (dates, texts over several lines) it refuses: the core then spells the scenario out.

import type { Scenario } from "./scenario";

/** What is not understood here; the core may still understand it. */
export class Unread extends Error {}

/** The tables that become fields. */
const OWN = new Set(["system", "system.parameters", "start", "run"]);

type Value = string | Value[] | Map<string, Value>;

/** Reads a scenario file. */
export function scenarioOf(text: string): Scenario {
  const root = new Map<string, Value>();
  const rest: string[] = [];
  let table = root;
  const reader = new Reader(text);
  while (reader.skip()) {
    if (reader.take("[[")) {
      rest.push(reader.section("[["));
    } else if (reader.take("[")) {
      const path = reader.path();
      reader.expect("]");
      const name = path.join(".");
      // Others are passed on as they stand: a body written out, an ensemble.
      if (OWN.has(name)) table = descend(root, path);
      else rest.push(reader.section(`[${name}]`));
    } else {
      const path = reader.path();
      const name = path.pop() ?? "";
      reader.expect("=");
      const own = descend(table, path);
      if (own.has(name)) throw new Unread(name);
      own.set(name, reader.value());
      reader.end();
    }
  }
  const system = inner(root, "system");
  const run = texts(inner(root, "run"));
  const { method = "", ...settings } = run;
  return {
    title: word(root.get("title")),
    label: word(root.get("label")),
    system: word(system.get("id")),
    parameters: texts(inner(system, "parameters")),
    start: texts(inner(root, "start")),
    method,
    run: settings,
    rest: rest.join("\n\n"),
  };
}

/** The system of a scenario file; empty where it is not understood. */
export function systemIn(text: string): string {
  try {
    return scenarioOf(text).system;
  } catch {
    return "";
  }
}

function descend(table: Map<string, Value>, path: string[]): Map<string, Value> {
  for (const name of path) {
    const next = table.get(name) ?? new Map<string, Value>();
    if (!(next instanceof Map)) throw new Unread(name);
    table.set(name, next);
    table = next;
  }
  return table;
}

function inner(table: Map<string, Value>, name: string): Map<string, Value> {
  const value = table.get(name) ?? new Map<string, Value>();
  if (!(value instanceof Map)) throw new Unread(name);
  return value;
}

function word(value: Value | undefined): string {
  if (value !== undefined && typeof value !== "string") throw new Unread("text");
  return value ?? "";
}

/** A value as it is typed into a field: a list is `[10; 1]`. */
function typed(value: Value): string {
  if (value instanceof Map) throw new Unread("table");
  return typeof value === "string" ? value : `[${value.map(typed).join("; ")}]`;
}

function texts(table: Map<string, Value>): Record<string, string> {
  return Object.fromEntries([...table].map(([name, value]) => [name, typed(value)]));
}

const ESCAPES: Record<string, string> = { n: "\n", t: "\t", r: "\r", '"': '"', "\\": "\\", b: "\b", f: "\f" };

class Reader {
  readonly #text: string;
  #at = 0;

  constructor(text: string) {
    this.#text = text;
  }

  #match(pattern: RegExp): string | undefined {
    pattern.lastIndex = this.#at;
    const found = pattern.exec(this.#text)?.[0];
    if (found !== undefined) this.#at += found.length;
    return found;
  }

  /** Over blanks, lines and remarks; whether anything comes after them. */
  skip(): boolean {
    this.#match(/(?:[\s]|#[^\n]*)*/y);
    return this.#at < this.#text.length;
  }

  take(token: string): boolean {
    this.#match(/[ \t]*/y);
    const found = this.#text.startsWith(token, this.#at);
    if (found) this.#at += token.length;
    return found;
  }

  expect(token: string): void {
    if (!this.take(token)) throw new Unread(token);
  }

  /** Nothing but a remark may follow on the line. */
  end(): void {
    if (this.#match(/[ \t]*(?:#[^\n]*)?(?:\r?\n|$)/y) === undefined) throw new Unread("end of line");
  }

  /** The lines up to the next table, after what opened this one. */
  section(opening: string): string {
    const lines = /[^\n]*(?:\n(?![ \t]*\[)[^\n]*)*/y;
    return `${opening}${this.#match(lines) ?? ""}`.trim();
  }

  path(): string[] {
    const names: string[] = [];
    do {
      this.#match(/[ \t]*/y);
      const name = this.#text[this.#at] === '"' ? this.#string() : this.#match(/[A-Za-z0-9_-]+/y);
      if (name === undefined) throw new Unread("name");
      names.push(name);
    } while (this.take("."));
    return names;
  }

  value(depth = 0): Value {
    if (depth > 16) throw new Unread("depth");
    this.#match(/[ \t]*/y);
    const next = this.#text[this.#at];
    if (next === '"' || next === "'") return this.#string();
    if (this.take("[")) return this.#list(depth);
    if (this.take("{")) return this.#table(depth);
    const plain = this.#match(/(?:true|false|[+-]?\d[\d_]*(?:\.\d[\d_]*)?(?:[eE][+-]?\d+)?)(?![\w:.-])/y);
    if (plain === undefined) throw new Unread("value");
    return plain.replaceAll("_", "");
  }

  #string(): string {
    if (/^(?:"""|''')/.test(this.#text.slice(this.#at, this.#at + 3))) throw new Unread("text");
    const literal = this.#match(/'[^'\n]*'/y);
    if (literal !== undefined) return literal.slice(1, -1);
    const basic = this.#match(/"(?:[^"\\\n]|\\.)*"/y);
    if (basic === undefined) throw new Unread("text");
    return basic.slice(1, -1).replace(/\\(u[\da-fA-F]{4}|U[\da-fA-F]{8}|.)/g, (_, escape: string) => {
      const code = /^[uU](.+)$/.exec(escape)?.[1];
      if (code !== undefined) {
        const point = parseInt(code, 16);
        if (!(point <= 0x10ffff)) throw new Unread("escape");
        return String.fromCodePoint(point);
      }
      const plain = ESCAPES[escape];
      if (plain === undefined) throw new Unread("escape");
      return plain;
    });
  }

  #list(depth: number): Value[] {
    const items: Value[] = [];
    for (;;) {
      this.skip();
      if (this.take("]")) return items;
      items.push(this.value(depth + 1));
      this.skip();
      if (this.take("]")) return items;
      this.expect(",");
    }
  }

  #table(depth: number): Map<string, Value> {
    const table = new Map<string, Value>();
    if (this.take("}")) return table;
    do {
      const path = this.path();
      const name = path.pop() ?? "";
      this.expect("=");
      const own = descend(table, path);
      if (own.has(name)) throw new Unread(name);
      own.set(name, this.value(depth + 1));
    } while (this.take(","));
    this.expect("}");
    return table;
  }
}
