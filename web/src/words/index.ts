import type { Language } from "../lab/number";
import { en, type Words } from "./en";

export type { Words };

/** The words of a language; whoever reads English loads no French. */
export async function wordsOf(language: Language): Promise<Words> {
  return language === "fr" ? (await import("./fr")).fr : en;
}
