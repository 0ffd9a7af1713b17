// SPDX-License-Identifier: GPL-3.0-or-later
// Rows that stay where they are while a panel is looked at: what is dragged or clicked there does not slip away.
import { useRef } from "preact/hooks";

// `items` with those first that were shown before, in the order in which they were; of the others, those that are wanted.
export function kept<T>(
  before: readonly string[],
  items: readonly T[],
  keyOf: (item: T) => string,
  isWanted: (item: T) => boolean,
): T[] {
  const byKey = new Map(items.map((item) => [keyOf(item), item]));
  const known = before.filter((key) => byKey.has(key));
  const isKnown = new Set(known);
  return [
    ...known.map((key) => byKey.get(key)!),
    ...items.filter((item) => !isKnown.has(keyOf(item)) && isWanted(item)),
  ];
}

export function useKept<T>(items: readonly T[], keyOf: (item: T) => string, isWanted: (item: T) => boolean): T[] {
  const shown = useRef<readonly string[]>([]);
  const list = kept(shown.current, items, keyOf, isWanted);
  // While an explanation is fetched there are none; the order outlasts that.
  if (list.length > 0) shown.current = list.map(keyOf);
  return list;
}
