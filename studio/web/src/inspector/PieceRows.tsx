// SPDX-License-Identifier: GPL-3.0-or-later
import { Icon } from "../app/Icon";
import type { OpenRoom } from "../state/open_room";
import { nameOf, type Piece } from "../state/pieces";
import { capital } from "./words";

// A row a piece: shown on the plan while it is pointed at, selected by a click.
export function PieceRows({ room, pieces }: { room: OpenRoom; pieces: readonly Piece[] }) {
  return (
    <ul class="pieces">
      {pieces.map((piece) => (
        <li key={piece.id}>
          <button class="piece-row" onClick={() => room.select([piece.id])}
            onPointerEnter={() => { room.hovered.value = piece.id; }} onPointerLeave={() => { room.hovered.value = ""; }}>
            {capital(nameOf(piece.object))}
            {piece.pinned && <Icon name="lock" size={13} />}
          </button>
        </li>
      ))}
    </ul>
  );
}
