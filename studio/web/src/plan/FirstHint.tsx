// SPDX-License-Identifier: GPL-3.0-or-later
import { usePlan } from "./context";

// One line until something has been selected once.
export function FirstHint() {
  const { room, studio: { settings } } = usePlan();
  if (settings.hint.value === "seen" || room.pieces.value.size === 0) return null;
  if (room.selection.value.size > 0) queueMicrotask(() => { settings.hint.value = "seen"; });
  return <p class="first-hint">Click a piece to see why it stands there. Drag it to move it.</p>;
}
