// SPDX-License-Identifier: GPL-3.0-or-later
import { corners, moved, type Pose, type Size } from "../../geometry/footprint";
import { boxOf } from "../../geometry/polygon";
import { snapped, type Moving, type Target } from "../../geometry/snap";
import { add, sub, vec, type Vec } from "../../geometry/vec";
import { isBacked, mounted, turnedToWall, type Mounted } from "../../geometry/wall_mount";
import { ObjectKind } from "../../gen/flair/v1/object_list_pb";
import { footprintOf, guestsOf, isSolid, type Piece, type Poses } from "../../state/pieces";
import { tellLocked } from "../../state/commands";
import type { PlanController } from "../controller";
import { kDragStart, kSnapPixels, type Gesture } from "../gesture";
import { isForWall, keptInside, pushedBack } from "../walls";

// Several pieces by the box around them.
function movingOf(pieces: readonly Piece[], by: Vec): Moving {
  const { min, max } = boxOf(pieces.flatMap((piece) => footprintOf(piece, moved(piece.pose, by))));
  return { polygon: [min, vec(max.x, min.y), max, vec(min.x, max.y)], theta: 0 };
}

export function snapTargets(plan: PlanController, moving: readonly Piece[]): Target[] {
  const all = plan.room.pieces.peek();
  const ids = moving.map((piece) => piece.id);
  const own = new Set([...ids, ...guestsOf(all, ids)]);
  return [...all.values()].filter((piece) => !own.has(piece.id) && isSolid(piece))
    .map((piece) => ({ id: piece.id, polygon: footprintOf(piece), theta: piece.pose.theta }));
}

// Where a lone piece comes to rest when the pointer wants it there: what hangs goes along the walls, what has its back at
// a wall turns it to the wall that it is brought to.
export function restOf(
  plan: PlanController,
  { kind, size, pose, isBackedUp }: { kind: ObjectKind; size: Size; pose: Pose; isBackedUp: boolean },
  targets: readonly Target[],
): Mounted {
  const within = kSnapPixels / plan.view.peek().scale, floor = plan.room.floor.peek();
  const hung = kind === ObjectKind.WALL ? mounted(pose, size, floor, targets, within) : undefined;
  if (hung) return hung;
  const wanted = isBackedUp ? turnedToWall(pose, size, floor, within) : pose;
  const { by, guides } = snapped({ polygon: corners(wanted, size), theta: wanted.theta }, floor, targets, within);
  const snap = moved(wanted, by);
  return { pose: kind === ObjectKind.FLOOR ? keptInside(snap, size, floor) : snap, guides };
}

// Drags the selected pieces; alt lets them go anywhere, shift keeps to one axis. A press without a move is a click.
export function moveGesture(
  plan: PlanController,
  start: PointerEvent,
  { clicked, dragged }: { clicked: string; dragged: string },
): Gesture {
  const before = plan.room.selection.peek();
  const taken = before.has(dragged) ? before : new Set(start.shiftKey ? [...before, dragged] : [dragged]);
  const from = plan.pointOf(start), at = plan.pixelOf(start);
  plan.lastClick = undefined;
  const chosen = [...plan.room.pieces.peek().values()].filter(({ id }) => taken.has(id));
  const movable = chosen.filter((piece) => !piece.pinned);
  const targets = snapTargets(plan, movable);
  const edges = plan.room.layout.peek()?.graph?.edges ?? [];
  const isBackedUp = movable.length === 1 && isSolid(movable[0]!)
    && (isForWall(edges, movable[0]!.id) || isBacked(movable[0]!.pose, movable[0]!.size, plan.room.floor.peek()));
  let poses: Poses | undefined, isBegun = false;

  function byOf(event: PointerEvent): Vec {
    const by = sub(plan.pointOf(event), from);
    if (!event.shiftKey) return by;
    return Math.abs(by.x) > Math.abs(by.y) ? vec(by.x, 0) : vec(0, by.y);
  }

  return {
    cursor: movable.length > 0 ? "move" : "not-allowed",
    move(event) {
      if (!isBegun && Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY) < kDragStart) return;
      if (!isBegun && taken !== before) plan.room.select(taken);
      isBegun = true;
      if (movable.length === 0) return;
      let by = byOf(event);
      const [only, ...others] = movable;
      if (event.altKey) {
        plan.guides.value = [];
      } else if (only && others.length === 0) {
        const pose = moved(only.pose, by);
        const rest = restOf(plan, { kind: only.object.kind, size: only.size, pose, isBackedUp }, targets);
        plan.guides.value = rest.guides;
        poses = new Map([[only.id, rest.pose]]);
        return plan.preview(poses);
      } else {
        const within = kSnapPixels / plan.view.peek().scale;
        const snap = snapped(movingOf(movable, by), plan.room.floor.peek(), targets, within);
        by = add(by, snap.by);
        const onFloor = movable.filter(isSolid).map((piece) => footprintOf(piece, moved(piece.pose, by)));
        if (onFloor.length > 0) by = add(by, pushedBack(onFloor, plan.room.floor.peek()));
        plan.guides.value = snap.guides;
      }
      poses = new Map(movable.map((piece) => [piece.id, moved(piece.pose, by)]));
      plan.preview(poses);
    },
    end() {
      if (poses) return void plan.drop(poses);
      if (isBegun) {
        tellLocked(plan.room, chosen);
        return;
      }
      plan.lastClick = at;
      const others = [...before].filter((id) => id !== clicked);
      if (!start.shiftKey) plan.room.select([clicked]);
      else plan.room.select(before.has(clicked) ? others : [...before, clicked]);
    },
    cancel() {
      plan.abandon();
      plan.room.select(before);
    },
  };
}
