// The arithmetic of the time bar. Whatever is shown is a sample of the run; nothing in between is made up.

/** How fast the clock may run: seconds of the run in a second of the viewer. */
export const SPEEDS = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100] as const;

/** The slowest of these, real time at the least, that shows a run within a minute. */
export function pace(times: Float64Array): number {
  const length = Math.abs((times.at(-1) ?? 0) - (times[0] ?? 0));
  return SPEEDS.find((speed) => speed >= 1 && length / speed <= 60) ?? SPEEDS[SPEEDS.length - 1] ?? 1;
}

/** The last sample that is not after a time; runs may go backwards. */
export function sampleAt(times: Float64Array, t: number): number {
  const sign = Math.sign((times.at(-1) ?? 0) - (times[0] ?? 0)) || 1;
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (sign * (times[middle] ?? 0) <= sign * t) low = middle;
    else high = middle - 1;
  }
  return Math.max(low, 0);
}

/** The sample nearest to a time. */
export function nearest(times: Float64Array, t: number): number {
  const before = sampleAt(times, t);
  const after = Math.min(before + 1, times.length - 1);
  return Math.abs((times[after] ?? 0) - t) < Math.abs((times[before] ?? 0) - t) ? after : before;
}

/** Where the clock is after some time of the viewer, and whether it has come to the end. */
export function advance(
  times: Float64Array,
  t: number,
  seconds: number,
  { speed, reverse, loop }: { speed: number; reverse: boolean; loop: boolean },
): { t: number; ended: boolean } {
  const first = times[0] ?? 0;
  const last = times.at(-1) ?? 0;
  const forwards = last < first === reverse;
  const next = t + (forwards ? 1 : -1) * speed * seconds;
  const [low, high] = first < last ? [first, last] : [last, first];
  if (next >= low && next <= high) return { t: next, ended: false };
  const [here, there] = next > high ? [high, low] : [low, high];
  return loop ? { t: there, ended: false } : { t: here, ended: true };
}
