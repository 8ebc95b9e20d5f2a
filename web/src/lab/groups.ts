// Quantities that are many: those of one body, rod or bucket go together, and a list shows one such group at a time.

/** As many as a list shows whole. */
export const MANY = 18;

/** The number in a name: the body it belongs to. */
const NUMBERED = /^[a-z_]+?(\d+)(_dot)?$/;

export const groupOf = (name: string) => NUMBERED.exec(name)?.[1];

/** The groups among some names, in order; none where the names are few. */
export function groupsOf(names: readonly string[]): string[] {
  if (names.length <= MANY) return [];
  const groups = [...new Set(names.flatMap((name) => groupOf(name) ?? []))];
  return groups.length > 1 ? groups : [];
}

/** What a list of them shows: all where they are few, else those of no group and of one. */
export function listed(names: readonly string[], group: string): string[] {
  const groups = groupsOf(names);
  const one = groups.includes(group) ? group : groups[0];
  return names.filter((name) => !groups.includes(groupOf(name) ?? "") || groupOf(name) === one);
}
