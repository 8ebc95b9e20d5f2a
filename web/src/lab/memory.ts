// What the browser keeps from one visit to the next.

export function remembered<T extends string>(key: string, choices: readonly T[]): T | undefined {
  try {
    const found = localStorage.getItem(`precess.${key}`);
    return choices.find((choice) => choice === found);
  } catch {
    return undefined;
  }
}

export function remember(key: string, value: string): void {
  try {
    localStorage.setItem(`precess.${key}`, value);
  } catch {
    // A browser that keeps nothing still runs the lab.
  }
}
