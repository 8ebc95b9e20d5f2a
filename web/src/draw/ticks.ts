/** Round numbers that divide a range into about so many parts: a third more at most, hardly more than half as few. */
export function ticks(low: number, high: number, parts: number): number[] {
  const span = high - low;
  if (!(span > 0) || !Number.isFinite(span)) return [low];
  const raw = span / Math.max(parts, 1);
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = ([1, 2, 5].find((digit) => digit * power >= raw * 0.75) ?? 10) * power;
  const from = Math.ceil(low / step - 1e-9);
  const to = Math.floor(high / step + 1e-9);
  return Array.from({ length: Math.max(to - from + 1, 0) }, (_, k) => (from + k) * step);
}

/** The range of some lists of numbers, with a little air. */
export function rangeOf(lists: Iterable<Float64Array>): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const list of lists) {
    for (const x of list) {
      if (!Number.isFinite(x)) continue;
      if (x < low) low = x;
      if (x > high) high = x;
    }
  }
  if (low > high) return [-1, 1];
  const air = (high - low) * 0.05 || Math.abs(high) * 0.05 || 1;
  return [low - air, high + air];
}
