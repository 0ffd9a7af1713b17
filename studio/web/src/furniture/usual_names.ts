// SPDX-License-Identifier: GPL-3.0-or-later
import usual from "./usual.json";

const likes: Readonly<Record<string, string>> = { study: "home office", office: "home office", "child's bedroom": "children's room" };

// Names of the catalogue for a kind of room, also for one such as "master bedroom".
export function usualNames(roomType: string): readonly string[] {
  const lists: Readonly<Record<string, readonly string[]>> = usual, kind = roomType.replace(/_/g, " ").toLowerCase();
  const listOf = (name: string) => lists[name] ?? lists[likes[name] ?? ""];
  const alike = [...Object.keys(likes), ...Object.keys(lists)].find((one) => kind.endsWith(one));
  return listOf(kind) ?? listOf(alike ?? "") ?? [];
}
