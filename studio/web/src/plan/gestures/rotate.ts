// SPDX-License-Identifier: GPL-3.0-or-later
import { center, type Pose } from "../../geometry/footprint";
import { boxOf } from "../../geometry/polygon";
import { heldInside } from "../../geometry/wall_mount";
import { ObjectKind } from "../../gen/flair/v1/object_list_pb";
import { snappedAngle } from "../../geometry/snap";
import { add, middle, sub, turned, type Vec } from "../../geometry/vec";
import { footprintOf, type Piece, type Poses } from "../../state/pieces";
import type { PlanController } from "../controller";
import type { Gesture } from "../gesture";

const kStep = Math.PI / 12;

// Around its own middle for one, around the middle of the box for several.
export function pivotOf(pieces: readonly Piece[]): Vec {
  if (pieces.length === 1) return center(pieces[0]!.pose);
  const { min, max } = boxOf(pieces.flatMap((piece) => footprintOf(piece)));
  return middle(min, max);
}

export function rotated(pieces: readonly Piece[], pivot: Vec, angle: number): Poses {
  return new Map(pieces.map(({ id, pose }): [string, Pose] => {
    const at = add(pivot, turned(sub(center(pose), pivot), angle));
    return [id, { x: at.x, y: at.y, theta: pose.theta + angle }];
  }));
}

// A lone piece does not turn into walls.
export function turnedInside(plan: PlanController, pieces: readonly Piece[], angle: number): Poses {
  const poses = rotated(pieces, pivotOf(pieces), angle), [only, ...others] = pieces;
  if (!only || others.length > 0 || only.object.kind !== ObjectKind.FLOOR) return poses;
  return new Map([[only.id, heldInside(poses.get(only.id)!, only.size, plan.room.floor.peek())]]);
}

// Turns by the handle, in steps of 15 degrees; alt turns freely.
export function rotateGesture(plan: PlanController, start: PointerEvent): Gesture {
  const pieces = plan.chosen.peek().filter((piece) => !piece.pinned);
  const pivot = pivotOf(pieces.length > 0 ? pieces : plan.chosen.peek());
  const angleOf = (event: PointerEvent) => {
    const arm = sub(plan.pointOf(event), pivot);
    return Math.atan2(arm.y, arm.x);
  };
  const from = angleOf(start);
  const heading = pieces.length === 1 ? pieces[0]!.pose.theta : 0;
  let poses: Poses | undefined;
  return {
    cursor: "grabbing",
    move(event) {
      if (pieces.length === 0) return;
      const free = heading + angleOf(event) - from;
      const theta = event.altKey ? free : snappedAngle(free, kStep, kStep / 2);
      poses = event.altKey ? rotated(pieces, pivot, theta - heading) : turnedInside(plan, pieces, theta - heading);
      plan.preview(poses);
    },
    end() { if (poses) void plan.drop(poses); },
    cancel() { plan.abandon(); },
  };
}
