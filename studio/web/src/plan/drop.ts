// SPDX-License-Identifier: GPL-3.0-or-later
// Furniture that is dragged from the drawer into the room.
import { useEffect } from "preact/hooks";
import { corners } from "../geometry/footprint";
import { snapped } from "../geometry/snap";
import { add } from "../geometry/vec";
import { addPiece } from "../state/commands";
import type { PlanController } from "./controller";
import { carried } from "../furniture/carried";
import { kSnapPixels } from "./gesture";
import { snapTargets } from "./gestures/move";

export function usePlanDrop(plan: PlanController, host: { current: HTMLElement | null }): void {
  useEffect(() => {
    const element = host.current!;
    const poseOf = (event: DragEvent) => {
      const object = carried.peek()!;
      const pose = { ...plan.pointOf(event), theta: 0 };
      const size = { width: object.widthM, depth: object.depthM };
      const snap = snapped({ polygon: corners(pose, size), theta: 0 }, plan.room.floor.peek(), snapTargets(plan, []),
        kSnapPixels / plan.view.peek().scale);
      plan.guides.value = snap.guides;
      return { ...add(pose, snap.by), theta: 0 };
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
      void addPiece(plan.room, object, pose);
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
