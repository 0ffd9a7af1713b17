// SPDX-License-Identifier: GPL-3.0-or-later
import { footprintOf, type Piece } from "../../state/pieces";
import { usePlan } from "../context";
import { resizing } from "../gestures/resize";
import { corners, toRoom, type Pose } from "../../geometry/footprint";
import { vec } from "../../geometry/vec";
import { Icon } from "../../app/Icon";
import { toScreen } from "../view";
import { pixelPoints } from "./pixels";

// Within a corner at its back.
const kInset = 0.12;
const lockAt = ({ size: { width, depth } }: Piece, pose: Pose) => {
  const x = Math.max(width / 2 - kInset, 0), y = Math.max(depth / 2 - kInset, 0);
  return toRoom(pose, vec(-x, -y));
};

// Outlines of what is selected, pointed at and named by a sentence; locks; the marquee.
export function Outlines() {
  const plan = usePlan(), { room } = plan;
  const view = plan.view.value, pieces = room.pieces.value;
  const selected = room.selection.value, hovered = room.hovered.value;
  const named = new Set(room.pointedAt.value?.other_object_ids);
  const outline = (id: string, name: string) => {
    const piece = pieces.get(id);
    const pulled = resizing.value?.id === id ? resizing.value.to : undefined;
    const pose = room.poseOf(id);
    if (!piece || !pose) return null;
    const polygon = pulled ? corners(pulled.pose, pulled.size) : footprintOf(piece, pose);
    return <polygon key={`${name} ${id}`} class={`outline ${name}`} points={pixelPoints(view, polygon)} />;
  };
  const marquee = plan.marquee.value;
  return (
    <g pointer-events="none">
      {hovered && !selected.has(hovered) && !plan.gesture.value && outline(hovered, "is-hovered")}
      {[...named].map((id) => outline(id, "is-named"))}
      {[...pieces.values()].filter(({ pinned }) => pinned).map((piece) => {
        const { x, y } = toScreen(view, lockAt(piece, room.poseOf(piece.id) ?? piece.pose));
        return <g key={piece.id} class="piece-lock" transform={`translate(${x} ${y})`}>
          <circle r={8} /><g transform="translate(-5.5 -5.5)"><Icon name="lock" size={11} /></g>
        </g>;
      })}
      {[...selected].map((id) => outline(id, pieces.get(id)?.pinned ? "is-selected is-locked" : "is-selected"))}
      {marquee && <rect class="marquee" x={marquee.min.x} y={marquee.min.y} width={marquee.max.x - marquee.min.x}
        height={marquee.max.y - marquee.min.y} />}
    </g>
  );
}
