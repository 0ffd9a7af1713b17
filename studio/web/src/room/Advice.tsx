// SPDX-License-Identifier: GPL-3.0-or-later
// What a click would do, above the drawing.
import { useDrawing } from "./context";

export function Advice() {
  const drawing = useDrawing(),
    mode = drawing.mode.value,
    { corners } = drawing.sketch.value;
  const texts = {
    scale: "",
    select: "",
    pen:
      corners.length === 0
        ? "Click where the first corner is."
        : corners.length < 3
          ? "Click the next corner, or type how far it is."
          : "Click the next corner. The first one closes the room.",
    door: "Click a wall to place the door.",
    window: "Click a wall to place the window.",
    socket: "Click a wall to place the socket.",
  };
  return (
    <p class="room-advice" aria-live="polite">
      {texts[mode]}
    </p>
  );
}
