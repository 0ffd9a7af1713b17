// SPDX-License-Identifier: GPL-3.0-or-later
// The field in which a clearance is typed, over the figure that was clicked.
import { signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { figure, parseLength } from "../app/units";
import { withClearance } from "../geometry/clearance";
import { middle } from "../geometry/vec";
import { shownClearances } from "./clearance_of";
import { usePlan } from "./context";
import { toScreen } from "./view";

export const editedClearance = signal<{ pieceId: string; side: string } | undefined>(undefined);

export function ClearanceField() {
  const plan = usePlan();
  const input = useRef<HTMLInputElement>(null);
  const edited = editedClearance.value;
  const shown = edited && shownClearances(plan);
  const clearance =
    shown?.piece.id === edited?.pieceId ? shown?.list.find((one) => one.side === edited?.side) : undefined;
  const units = plan.studio.settings.units.value;
  const at = clearance && middle(toScreen(plan.view.value, clearance.from), toScreen(plan.view.value, clearance.to));
  useEffect(() => {
    if (!input.current || !at) return;
    input.current.style.transform = `translate(${Math.round(at.x - 34)}px, ${Math.round(at.y - 13)}px)`;
  }, [at?.x, at?.y, edited]);
  useEffect(() => input.current?.select(), [edited]);
  if (!edited || !shown || !clearance) return null;

  const close = () => {
    editedClearance.value = undefined;
    plan.element?.parentElement?.focus({ preventScroll: true });
  };
  const take = () => {
    const metres = parseLength(input.current!.value, units);
    if (metres === undefined) return input.current!.setAttribute("aria-invalid", "true");
    const pose = plan.room.poseOf(shown.piece.id) ?? shown.piece.pose;
    close();
    if (Math.abs(metres - clearance.metres) > 1e-4) {
      void plan.drop(new Map([[shown.piece.id, withClearance(pose, clearance, metres)]]));
    }
  };
  return (
    <input
      ref={input}
      key={edited.side}
      class="clearance-field"
      defaultValue={figure(clearance.metres, units)}
      aria-label={`${edited.side} clearance`}
      onBlur={() => {
        if (editedClearance.peek() === edited) close();
      }}
      onKeyDown={(event) => {
        event.stopPropagation();
        if (event.key === "Enter") take();
        if (event.key === "Tab") {
          event.preventDefault();
          const sides = shown.list.map((one) => one.side),
            by = event.shiftKey ? sides.length - 1 : 1;
          editedClearance.value = {
            pieceId: edited.pieceId,
            side: sides[(sides.indexOf(edited.side) + by) % sides.length]!,
          };
        }
        if (event.key === "Escape") close();
      }} />
  );
}
