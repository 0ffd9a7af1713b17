// SPDX-License-Identifier: GPL-3.0-or-later
import { boxOf } from "../../geometry/polygon";
import type { Vec } from "../../geometry/vec";
import type { PlanPart } from "../../gen/flair/v1/renderer_service_pb";
import { footprintOf, isSolid, nameOf, type Piece } from "../../state/pieces";
import { usePlan } from "../context";
import { toScreen } from "../view";

const kLeading = 1.18;
const kSmallest = 7.5;
const kLargest = 15;
const kPlainSize = 11.5;

function Text({ lines, at, size, name }: { lines: readonly string[]; at: Vec; size: number; name: string }) {
  const first = at.y + size * 0.35 - ((lines.length - 1) * size * kLeading) / 2;
  return (
    <text class={name} font-size={size}>
      {lines.map((line, i) => <tspan key={i} x={at.x} y={first + i * size * kLeading}>{line}</tspan>)}
    </text>
  );
}

// The name of a piece that is pointed at, above it where it has none on it.
function pointed(piece: Piece, at: Vec, top: number) {
  return <Text key={piece.id} lines={[nameOf(piece.object)]} at={{ x: at.x, y: top - 11 }} size={kPlainSize} name="is-pointed" />;
}

// The renderer's labels, upright and no larger than reads well; without a drawing, the names of what stands on the floor.
export function Labels() {
  const plan = usePlan(), { room } = plan, view = plan.view.value;
  const parts = new Map<string, PlanPart>(room.parts.value?.parts.map((part) => [part.objectId, part]));
  const hovered = plan.gesture.value ? "" : room.hovered.value;
  return (
    <g class="labels" pointer-events="none">
      {[...room.pieces.value.values()].map((piece) => {
        const pose = room.poseOf(piece.id) ?? piece.pose, at = toScreen(view, pose);
        const part = parts.get(piece.id);
        const label = part?.label ?? (isSolid(piece) ? piece.object.name : "");
        const size = part?.label ? part.labelSizeM * view.scale : kPlainSize;
        if (hovered === piece.id && (!label || size < kSmallest)) {
          return pointed(piece, at, toScreen(view, boxOf(footprintOf(piece, pose)).max).y);
        }
        if (!label || size < kSmallest) return null;
        const shift = { x: (part?.labelXM ?? 0) * view.scale, y: (part?.labelYM ?? 0) * view.scale };
        return <Text key={piece.id} lines={label.split("\n")} at={{ x: at.x + shift.x, y: at.y + shift.y }}
          size={Math.min(size, kLargest)} name="" />;
      })}
    </g>
  );
}
