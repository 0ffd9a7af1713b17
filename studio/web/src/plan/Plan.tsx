// SPDX-License-Identifier: GPL-3.0-or-later
// The plan: the renderer's drawing in parts that are moved, and what is drawn above it in pixels.
import { batch, useComputed } from "@preact/signals";
import { useEffect, useMemo, useRef } from "preact/hooks";
import { objectIn } from "../inspector/note";
import { nameOf } from "../state/pieces";
import type { OpenRoom } from "../state/open_room";
import { useStudio } from "../state/studio";
import { PlanController } from "./controller";
import { usePlanKeys } from "./keys";
import { Overlay } from "./Overlay";
import { PieceLayers } from "./PieceLayers";
import { PlanContext } from "./context";
import { usePlanPointer } from "./pointer";
import { usePlanWheel } from "./wheel";
import { ClearanceField } from "./ClearanceField";
import { ViewTools } from "./ViewTools";
import { usePlanDrop } from "./drop";

function useSize(plan: PlanController, host: { current: HTMLDivElement | null }): void {
  useEffect(() => {
    const observer = new ResizeObserver(([entry]) => {
      const { width, height } = entry!.contentRect;
      batch(() => {
        plan.width.value = width;
        plan.height.value = height;
        if (!plan.isViewOwn) plan.fit();
      });
    });
    observer.observe(host.current!);
    return () => observer.disconnect();
  }, [plan]);
}

// For screen readers: what is selected.
function Spoken({ room }: { room: OpenRoom }) {
  const chosen = [...room.selection.value].flatMap((id) => room.pieces.value.get(id) ?? []);
  const [only] = chosen;
  const stands = only && objectIn(room.explanation.value?.note, only.id)?.stands;
  const text = chosen.length > 1 ? `${chosen.length} pieces` : only ? `${nameOf(only.object)} ${stands ?? ""}` : "";
  return <p class="only-spoken" aria-live="polite">{text}</p>;
}

export function Plan({ room }: { room: OpenRoom }) {
  const studio = useStudio();
  const plan = useMemo(() => new PlanController(room, studio), [room, studio]);
  const host = useRef<HTMLDivElement>(null);
  useSize(plan, host);
  useEffect(() => room.floor.subscribe(() => { if (!plan.isViewOwn) plan.fit(); }), [plan]);
  useEffect(() => plan.gesture.subscribe((gesture) => { room.isHeld.value = gesture !== undefined; }), [plan]);
  const pointer = usePlanPointer(plan);
  usePlanWheel(plan, host);
  usePlanDrop(plan, host);
  const keys = usePlanKeys(plan);
  const world = useComputed(() => {
    const { scale, left, top } = plan.view.value;
    return `matrix(${scale} 0 0 ${scale} ${left} ${top})`;
  });
  const isMeasured = useComputed(() => plan.width.value > 0);
  const cursor = useComputed(() => plan.gesture.value?.cursor ?? (plan.isSpaceDown.value ? "grab" : "default"));
  useEffect(() => cursor.subscribe((value) => { host.current!.style.cursor = value; }), [cursor]);
  return (
    <PlanContext.Provider value={plan}>
      <div
        class="plan"
        ref={host}
        tabIndex={0}
        role="application"
        aria-label="Plan of the room. Tab goes to the pieces, arrows move what is selected."
        {...keys}
      >
        <svg
          class="plan-drawing"
          ref={(element) => {
            plan.element = element;
          }}
          {...pointer}
        >
          {isMeasured.value && (
            <>
              <g transform={world}>
                <PieceLayers />
              </g>
              <Overlay />
            </>
          )}
        </svg>
        <ClearanceField />
        <Spoken room={room} />
        <ViewTools of={plan} />
      </div>
    </PlanContext.Provider>
  );
}
