// SPDX-License-Identifier: GPL-3.0-or-later
// Furniture that is dragged from the drawer into the room.
import { useEffect } from "preact/hooks";
import { ObjectKind, type Object$ } from "../gen/flair/v1/object_list_pb";
import { addPiece } from "../state/commands";
import type { PlanController } from "./controller";
import { carried } from "../furniture/carried";
import { offerSeat } from "../furniture/seat";
import { restOf, snapTargets } from "./gestures/move";

// The lower edge of what hangs: what comes down from a ceiling ends its height below it.
function hungAt({ kind, elevationM, heightM }: Object$, ceilingM: number): number {
  if (kind === ObjectKind.CEILING && elevationM === 0) return Math.max(0, ceilingM - heightM);
  return kind === ObjectKind.WALL || kind === ObjectKind.CEILING ? elevationM : 0;
}

export function usePlanDrop(plan: PlanController, host: { current: HTMLElement | null }): void {
  useEffect(() => {
    const element = host.current!;
    const poseOf = (event: DragEvent) => {
      const object = carried.peek()!;
      const { kind, walkOver, round } = object, pose = { ...plan.pointOf(event), theta: 0 };
      const size = { width: object.widthM, depth: object.depthM };
      const isBackedUp = kind === ObjectKind.FLOOR && !walkOver && !round;
      const rest = restOf(plan, { kind, size, pose, isBackedUp }, snapTargets(plan, []));
      plan.guides.value = rest.guides;
      return rest.pose;
    };
    const onOver = (event: DragEvent) => {
      if (!carried.peek()) return;
      event.preventDefault();
      poseOf(event);
    };
    const onDrop = (event: DragEvent) => {
      const object = carried.peek();
      if (!object) return;
      event.preventDefault();
      event.stopPropagation();
      const pose = poseOf(event);
      plan.guides.value = [];
      element.focus({ preventScroll: true });
      const z = hungAt(object, plan.room.layout.peek()?.graph?.room?.heightM ?? 0);
      void addPiece(plan.room, object, pose, z).then((isAdded) => { if (isAdded) void offerSeat(plan.studio, plan.room); });
    };
    const onLeave = () => { plan.guides.value = []; };
    element.addEventListener("dragover", onOver);
    element.addEventListener("drop", onDrop);
    element.addEventListener("dragleave", onLeave);
    return () => {
      element.removeEventListener("dragover", onOver);
      element.removeEventListener("drop", onDrop);
      element.removeEventListener("dragleave", onLeave);
    };
  }, [plan]);
}
