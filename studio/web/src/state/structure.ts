// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two layouts are drawn with the same parts, so that only poses differ.
import { equals } from "@bufbuild/protobuf";
import { RoomSchema } from "../gen/flair/v1/room_pb";
import type { SolvedLayout } from "../gen/flair/v1/solved_layout_pb";

function looks(layout: SolvedLayout): string {
  const placed = new Set(layout.placements.map((one) => one.objectId));
  return (layout.graph?.objectList?.objects ?? []).filter((object) => placed.has(object.id))
    .map((one) => [one.id, one.name, one.category, one.widthM, one.depthM, one.heightM, one.kind].join(" ")).join("\n");
}

export function isDrawnAlike(a: SolvedLayout | undefined, b: SolvedLayout): boolean {
  if (!a?.graph || !b.graph) return a?.graph === b.graph;
  const roomA = a.graph.room, roomB = b.graph.room;
  if (!roomA || !roomB) return roomA === roomB;
  return looks(a) === looks(b) && equals(RoomSchema, roomA, roomB);
}
