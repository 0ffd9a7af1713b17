// SPDX-License-Identifier: GPL-3.0-or-later
// Two fingers pan, a pinch or ctrl and the wheel zoom at the pointer.
import { useEffect } from "preact/hooks";
import { vec } from "../geometry/vec";
import type { PlanController } from "./controller";
import { panned, zoomedAt } from "./view";

const kPixelsPerLine = 16;
const kZoomPerPixel = 0.0022;

// What is panned and zoomed: the plan, or a room that is drawn.
export type Viewed = Pick<PlanController, "view" | "setView" | "pixelOf">;

export function usePlanWheel(plan: Viewed, host: { current: HTMLElement | null }): void {
  useEffect(() => {
    const element = host.current!;
    const onWheel = (event: WheelEvent) => {
      event.preventDefault();
      const unit = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? kPixelsPerLine : 1;
      const view = plan.view.peek();
      if (event.ctrlKey || event.metaKey) {
        // A pinch comes as small steps, a wheel as large ones.
        const step = Math.max(-120, Math.min(120, event.deltaY * unit)) * (Math.abs(event.deltaY) < 20 ? 4 : 1);
        plan.setView(zoomedAt(view, plan.pixelOf(event), Math.exp(-step * kZoomPerPixel)));
      } else {
        const sideways = event.shiftKey && event.deltaX === 0;
        const by = sideways ? vec(event.deltaY, 0) : vec(event.deltaX, event.deltaY);
        plan.setView(panned(view, vec(-by.x * unit, -by.y * unit)));
      }
    };
    element.addEventListener("wheel", onWheel, { passive: false });
    return () => element.removeEventListener("wheel", onWheel);
  }, [plan]);
}
