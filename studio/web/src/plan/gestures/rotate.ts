// SPDX-License-Identifier: GPL-3.0-or-later
import { snappedAngle } from "../../geometry/snap";
import { sub } from "../../geometry/vec";
import type { Poses } from "../../state/pieces";
import { pivotOf, rotated, turnedInside } from "../../state/turning";
import type { PlanController } from "../controller";
import type { Gesture } from "../gesture";

const kStep = Math.PI / 12;

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
      poses = event.altKey ? rotated(pieces, pivot, theta - heading) : turnedInside(pieces, theta - heading, plan.room.floor.peek());
      plan.preview(poses);
    },
    end() { if (poses) void plan.drop(poses); },
    cancel() { plan.abandon(); },
  };
}
