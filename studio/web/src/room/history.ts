// SPDX-License-Identifier: GPL-3.0-or-later
// Undo and redo of whole states, each with what led to it.
export interface Entry<T> {
  readonly state: T;
  readonly label: string;
}

export interface History<T> {
  readonly past: ReadonlyArray<Entry<T>>;
  readonly now: Entry<T>;
  readonly future: ReadonlyArray<Entry<T>>;
}

const kMost = 300;

export const begun = <T>(state: T): History<T> => ({ past: [], now: { state, label: "" }, future: [] });

// With one more; the same state again is none.
export function pushed<T>({ past, now }: History<T>, state: T, label: string): History<T> {
  return { past: [...past, now].slice(-kMost), now: { state, label }, future: [] };
}

export function undone<T>({ past, now, future }: History<T>): History<T> {
  const before = past.at(-1);
  return before ? { past: past.slice(0, -1), now: before, future: [now, ...future] } : { past, now, future };
}

export function redone<T>({ past, now, future }: History<T>): History<T> {
  const [next, ...rest] = future;
  return next ? { past: [...past, now], now: next, future: rest } : { past, now, future };
}
