// SPDX-License-Identifier: GPL-3.0-or-later
// What lies above the drawing's corners: what a click would do, scale, zoom.
import { useEffect, useRef } from "preact/hooks";
import { Icon } from "../app/Icon";
import { vec } from "../geometry/vec";
import { zoomedAt } from "../plan/view";
import { useDrawing } from "./context";

// What a click would do.
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

const kSteps = { m: [0.1, 0.5, 1, 2, 5, 10], ft: [0.3048, 0.9144, 1.524, 3.048, 6.096, 15.24] };

function ScaleBar() {
  const drawing = useDrawing(),
    units = drawing.studio.settings.units.value,
    { scale } = drawing.view.value;
  const bar = useRef<HTMLDivElement>(null);
  const metres = [...kSteps[units]].reverse().find((step) => step * scale <= 130) ?? kSteps[units][0]!;
  useEffect(() => {
    bar.current!.style.width = `${metres * scale}px`;
  }, [metres, scale]);
  const text = units === "m" ? `${metres} m` : `${Math.round(metres / 0.3048)} ft`;
  return (
    <div class="scale-bar" aria-label={`Scale: this bar is ${text} long`}>
      <div ref={bar} />
      <span>{text}</span>
    </div>
  );
}

export function ZoomTools() {
  const drawing = useDrawing();
  const middle = () => vec(drawing.width.peek() / 2, drawing.height.peek() / 2);
  const zoom = (factor: number) => drawing.setView(zoomedAt(drawing.view.peek(), middle(), factor));
  return (
    <div class="plan-tools">
      <ScaleBar />
      <div class="button-group">
        <button class="icon-button" aria-label="Zoom out" title="Zoom out (-)" onClick={() => zoom(0.8)}>
          <Icon name="minus" />
        </button>
        <button class="icon-button" aria-label="Zoom in" title="Zoom in (+)" onClick={() => zoom(1.25)}>
          <Icon name="plus" />
        </button>
        <button class="icon-button" aria-label="Fit the room" title="Fit the room (0)" onClick={() => drawing.fit()}>
          <Icon name="fit" />
        </button>
      </div>
    </div>
  );
}
