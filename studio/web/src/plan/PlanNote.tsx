// SPDX-License-Identifier: GPL-3.0-or-later
import { usePlan } from "./context";

// One quiet line in the corner: the first help until something has been selected once, then whether all is settled.
export function PlanNote() {
  const { room, gesture, studio: { settings } } = usePlan();
  if (settings.hint.value === "new" && room.pieces.value.size > 0) {
    if (room.selection.value.size > 0) queueMicrotask(() => { settings.hint.value = "seen"; });
    return <p class="plan-note">Click a piece to see why it stands there. Drag it to move it.</p>;
  }
  if (!room.document.value.unsettled || gesture.value) return null;
  return <p class="plan-note is-due" title="The other pieces have not made room for what you changed">Not settled yet (S)</p>;
}
