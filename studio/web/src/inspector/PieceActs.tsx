// SPDX-License-Identifier: GPL-3.0-or-later
import { Icon } from "../app/Icon";
import { RemoveButton } from "../app/PanelHead";
import { duplicatePieces, lockPieces, removePieces, turnPieces, withCarried } from "../state/commands";
import type { OpenRoom } from "../state/open_room";
import type { Piece } from "../state/pieces";

// Lock, turn, duplicate and remove, of one piece or several.
export function PieceActs({ room, pieces }: { room: OpenRoom; pieces: readonly Piece[] }) {
  const isLocked = pieces.every((piece) => piece.pinned);
  const acts = [
    { name: isLocked ? "Unlock" : "Lock", key: "L", icon: isLocked ? "lock" : "unlock", run: lockPieces },
    { name: "Turn clockwise", key: "R", icon: "turn", run: () => turnPieces(room, pieces, -Math.PI / 2) },
    { name: "Duplicate", key: "Ctrl D", icon: "copy", run: () => duplicatePieces(room, withCarried(room, pieces)) },
  ] as const;
  return (
    <div class="button-group piece-acts">
      {acts.map(({ name, key, icon, run }) => (
        <button key={key} class="icon-button" aria-pressed={key === "L" ? isLocked : undefined} aria-label={name}
          title={`${name} (${key})`} onClick={() => void run(room, pieces)}>
          <Icon name={icon} />
        </button>
      ))}
      <RemoveButton label={pieces.length > 1 ? `Remove ${pieces.length} pieces` : "Remove the piece"}
        run={() => void removePieces(room, pieces.map((piece) => piece.id))} />
    </div>
  );
}
