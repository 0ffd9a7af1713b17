// SPDX-License-Identifier: GPL-3.0-or-later
// Rows that stay where they are while a panel is looked at: what is dragged or clicked there does not slip away.
import { useRef } from "preact/hooks";

// The wanted of `items`, those first that were shown before, in the order in which they were; among them also the one in
// hand that is wanted no more.
export function kept<T>(
  before: readonly string[],
  items: readonly T[],
  keyOf: (item: T) => string,
  isWanted: (item: T) => boolean,
  isInHand: (item: T) => boolean = () => false,
): T[] {
  const byKey = new Map(items.map((item) => [keyOf(item), item]));
  const stays = (item?: T): boolean => item !== undefined && (isWanted(item) || isInHand(item));
  const known = before.filter((key) => stays(byKey.get(key)));
  const isKnown = new Set(known);
  return [
    ...known.map((key) => byKey.get(key)!),
    ...items.filter((item) => !isKnown.has(keyOf(item)) && isWanted(item)),
  ];
}

export function useKept<T>(
  items: readonly T[],
  keyOf: (item: T) => string,
  isWanted: (item: T) => boolean,
  isInHand?: (item: T) => boolean,
): T[] {
  const shown = useRef<readonly string[]>([]);
  const list = kept(shown.current, items, keyOf, isWanted, isInHand);
  // While an explanation is fetched there are none; the order outlasts that.
  if (list.length > 0) shown.current = list.map(keyOf);
  return list;
}
