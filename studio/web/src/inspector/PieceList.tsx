// SPDX-License-Identifier: GPL-3.0-or-later
import type { OpenRoom } from "../state/open_room";
import type { Piece } from "../state/pieces";
import { PieceRows } from "./PieceRows";
import type { Note } from "./note";

function groupsOf(room: OpenRoom, note: Note): Array<{ name: string; pieces: Piece[] }> {
  const pieces = [...room.pieces.value.values()];
  const zones = room.layout.value?.graph?.zonePlan?.zones ?? [];
  const named = new Map([...zones.map(({ id, name }) => [id, name] as const),
    ...(note.zones ?? []).map(({ id = "", name = "" }) => [id, name] as const)]);
  const groups = [...new Set(pieces.map((piece) => piece.object.zoneId))].map((id) => ({
    name: named.get(id) || "whole room", pieces: pieces.filter((piece) => piece.object.zoneId === id),
  }));
  return groups;
}

// Everything in the room, by zones: the way to it without a mouse, and to what is hidden below something else.
export function PieceList({ room, note }: { room: OpenRoom; note: Note }) {
  return (
    <section>
      {groupsOf(room, note).map(({ name, pieces }) => (
        <div key={name}>
          <h3 class="eyebrow">{name}</h3>
          <PieceRows room={room} pieces={pieces} />
        </div>
      ))}
    </section>
  );
}
