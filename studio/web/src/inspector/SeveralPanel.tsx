// SPDX-License-Identifier: GPL-3.0-or-later
import { Icon } from "../app/Icon";
import { duplicatePieces, lockPieces, removePieces } from "../state/commands";
import type { OpenRoom } from "../state/open_room";
import type { Piece } from "../state/pieces";
import { Faults } from "./Faults";
import { PieceRows } from "./PieceRows";

export function SeveralPanel({ room, pieces }: { room: OpenRoom; pieces: readonly Piece[] }) {
  const isLocked = pieces.every((piece) => piece.pinned);
  return (
    <>
      <header class="panel-head">
        <h2>{pieces.length} pieces</h2>
        <div class="button-group">
          <button
            class="icon-button"
            aria-pressed={isLocked}
            aria-label={isLocked ? "Unlock them" : "Lock them"}
            title={isLocked ? "Unlock (L)" : "Lock (L)"}
            onClick={() => void lockPieces(room, pieces)}
          >
            <Icon name={isLocked ? "lock" : "unlock"} />
          </button>
          <button
            class="icon-button"
            aria-label="Duplicate them"
            title="Duplicate (Ctrl D)"
            onClick={() => void duplicatePieces(room, pieces)}
          >
            <Icon name="copy" />
          </button>
          <button
            class="icon-button"
            aria-label="Remove them"
            title="Remove (Delete)"
            onClick={() =>
              void removePieces(
                room,
                pieces.map((piece) => piece.id),
              )
            }
          >
            <Icon name="trash" />
          </button>
        </div>
      </header>
      <PieceRows room={room} pieces={pieces} />
      <Faults room={room} of={pieces} title="What is wrong with them" />
    </>
  );
}
