import type { Language } from "../lab/number";
import { en, type Words } from "./en";
import { fr } from "./fr";

export type { Words };
export const WORDS: Record<Language, Words> = { en, fr };
