// SPDX-License-Identifier: GPL-3.0-or-later
import { contains } from "../../geometry/footprint";
import { boxOf } from "../../geometry/polygon";
import { footprintOf, isSolid, nameOf, type Piece } from "../../state/pieces";
import { usePlan } from "../context";
import { toScreen } from "../view";

const kCharacter = 5.9;

function isCovered(piece: Piece, pieces: Iterable<Piece>): boolean {
  for (const other of pieces) {
    if (other.id !== piece.id && isSolid(other) && contains(other.pose, other.size, piece.pose)) return true;
  }
  return false;
}

// Names of what has room for its own, and of what is pointed at.
export function Labels() {
  const plan = usePlan(), { room } = plan, view = plan.view.value;
  const pieces = [...room.pieces.value.values()];
  const labels = new Map(room.parts.value?.parts.map((part) => [part.objectId, part.label]));
  const hovered = plan.gesture.value ? "" : room.hovered.value;
  return (
    <g class="labels" pointer-events="none">
      {pieces.map((piece) => {
        const pose = room.poseOf(piece.id) ?? piece.pose;
        const isPointed = hovered === piece.id;
        const text = isPointed ? nameOf(piece.object) : labels.get(piece.id) ?? (isSolid(piece) ? piece.object.name : "");
        if (!text) return null;
        const box = boxOf(footprintOf(piece, pose));
        const fits = text.length * kCharacter < (box.max.x - box.min.x) * view.scale + 14
          && (box.max.y - box.min.y) * view.scale > 15;
        if (!isPointed && (!fits || isCovered(piece, pieces))) return null;
        const at = toScreen(view, pose);
        const y = isPointed && !fits ? toScreen(view, box.max).y - 8 : at.y + 4;
        return <text key={piece.id} class={isPointed ? "is-pointed" : ""} x={at.x} y={y}>{text}</text>;
      })}
    </g>
  );
}
