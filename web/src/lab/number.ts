// Numbers as people of a language read them.

export type Language = "en" | "fr";

/** Some significant digits; a decimal comma in French. */
export function shown(x: number, language: Language, digits = 5): string {
  if (!Number.isFinite(x)) return Number.isNaN(x) ? "–" : x > 0 ? "∞" : "−∞";
  const size = Math.abs(x);
  const plain = x === 0 || (size >= 1e-3 && size < 1e6);
  const text = plain ? String(Number(x.toPrecision(digits))) : x.toExponential(digits - 1);
  const [mantissa = "", exponent] = text.split("e");
  // Zeros at the end of a fraction say nothing; those of an exponent do.
  const short = mantissa.includes(".") ? mantissa.replace(/\.?0+$/, "") : mantissa;
  const tidy = exponent === undefined ? short : `${short}e${exponent}`;
  return local(tidy.replace("e+", "e"), language);
}

/** A plain number's text in a language: comma and minus sign. */
export function local(text: string, language: Language): string {
  const signed = text.replaceAll("-", "−");
  return language === "fr" ? signed.replace(".", ",") : signed;
}

/** A text for a field: a plain number gets the language's comma, anything else stays as it is. */
export function inField(text: string, language: Language): string {
  return language === "fr" && /^[+-]?\d+\.\d+([eE][+-]?\d+)?$/.test(text) ? text.replace(".", ",") : text;
}

/** A field's text as a scenario keeps it: a plain number with a point. */
export function fromField(text: string): string {
  const tidy = text.trim().replace(/^−/, "-");
  return /^[+-]?\d+,\d+([eE][+-]?\d+)?$/.test(tidy) ? tidy.replace(",", ".") : tidy;
}

const RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** A unit as people write it: m², and nothing for a pure number. */
export function unitText(unit: string): string {
  if (unit === "1") return "";
  return unit.replace(/\^(\d+)/g, (_, power: string) =>
    power.replace(/\d/g, (digit) => RAISED[Number(digit)] ?? digit),
  );
}
