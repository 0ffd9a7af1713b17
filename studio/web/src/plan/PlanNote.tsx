// SPDX-License-Identifier: GPL-3.0-or-later
import { usePlan } from "./context";

// One quiet line in the corner: the first help, until something has been selected once.
export function PlanNote() {
  const { room, studio: { settings } } = usePlan();
  if (settings.hint.value !== "new" || room.pieces.value.size === 0) return null;
  if (room.selection.value.size > 0) queueMicrotask(() => { settings.hint.value = "seen"; });
  return <p class="plan-note">Click a piece to see why it stands there. Drag it to move it.</p>;
}
