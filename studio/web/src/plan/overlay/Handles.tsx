// SPDX-License-Identifier: GPL-3.0-or-later
import { measuredAlong } from "../../geometry/clearance";
import { toRoom } from "../../geometry/footprint";
import { boxOf, type Box } from "../../geometry/polygon";
import { gripAt, grips } from "../../geometry/resize";
import { add, length, sub, times, turned, unit, vec, type Vec } from "../../geometry/vec";
import { footprintOf, type Piece } from "../../state/pieces";
import { usePlan } from "../context";
import { resizing } from "../gestures/resize";
import { toScreen, type View } from "../view";

const kArm = 20;
const kGrip = 4;
// Smaller pieces on the screen are not resized by hand.
const kRoomForGrips = 36;
const kRoomForMiddles = 64;

// Off the front right corner of a lone piece, above the box of several: clear of the distances, which begin at middles;
// those of a turned piece begin at its corners, and the handle is before its front.
function rotateHandle(
  view: View,
  pieces: readonly Piece[],
  poseOf: (piece: Piece) => Piece["pose"],
  floor: readonly Vec[],
): [Vec, Vec] {
  const [only] = pieces;
  if (pieces.length === 1 && only) {
    const { theta } = poseOf(only);
    const beside = measuredAlong(theta, floor) === theta ? 1 : 0;
    const from = toScreen(view, toRoom(poseOf(only), vec((beside * only.size.width) / 2, only.size.depth / 2)));
    const outward = turned(unit(vec(beside, 1)), theta);
    return [from, add(from, times(vec(outward.x, -outward.y), kArm))];
  }
  const { min, max } = boxOf(pieces.flatMap((piece) => footprintOf(piece, poseOf(piece))));
  const from = toScreen(view, vec((min.x + max.x) / 2, max.y));
  return [from, add(from, vec(0, -kArm))];
}

// Around several pieces, which turn around its middle.
function Frame({ view, box: { min, max } }: { view: View; box: Box }) {
  const a = toScreen(view, vec(min.x, max.y)), b = toScreen(view, vec(max.x, min.y));
  return <rect class="outline is-frame" pointer-events="none" x={a.x} y={a.y} width={b.x - a.x} height={b.y - a.y} />;
}

export function Handles() {
  const plan = usePlan(), view = plan.view.value;
  const pieces = plan.chosen.value.filter((piece) => !piece.pinned);
  const [only] = pieces;
  if (!only || (plan.gesture.value && !resizing.value)) return null;
  const pulled = pieces.length === 1 && resizing.value?.id === only.id ? resizing.value.to : undefined;
  const poseOf = (piece: Piece) => pulled?.pose ?? plan.room.poseOf(piece.id) ?? piece.pose;
  const [from, to] = rotateHandle(view, pieces, poseOf, plan.room.floor.value);
  const frame = pieces.length > 1 ? boxOf(pieces.flatMap((piece) => footprintOf(piece, poseOf(piece)))) : undefined;
  const size = pulled?.size ?? only.size;
  const small = Math.min(size.width, size.depth) * view.scale;
  const shown =
    pieces.length > 1 || small < kRoomForGrips
      ? []
      : grips
          .map((grip, i) => ({ grip, i }))
          .filter(({ grip }) => small >= kRoomForMiddles || (grip.x !== 0 && grip.y !== 0));
  return (
    <g class="handles">
      {frame && <Frame view={view} box={frame} />}
      {!pulled && (
        <g data-rotate="" class="rotate-handle">
          <line x1={from.x} y1={from.y} x2={to.x} y2={to.y} />
          <circle class="hit" cx={to.x} cy={to.y} r={14} />
          <circle cx={to.x} cy={to.y} r={length(sub(to, from)) > 0 ? 5.5 : 0} />
        </g>
      )}
      {shown.map(({ grip, i }) => {
        const at = toScreen(view, gripAt(poseOf(only), size, grip));
        return (
          <g key={i} data-grip={i} class="grip">
            <rect class="hit" x={at.x - 9} y={at.y - 9} width={18} height={18} />
            <rect x={at.x - kGrip} y={at.y - kGrip} width={2 * kGrip} height={2 * kGrip} rx={1.5} />
          </g>
        );
      })}
    </g>
  );
}
