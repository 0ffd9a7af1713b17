// SPDX-License-Identifier: GPL-3.0-or-later
// The drawing of the room under way: grid, picture, floor, walls, what is in them, and handles.
import { useComputed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { boxOf } from "../geometry/polygon";
import { toScreen } from "../plan/view";
import { footprintOf, type Piece } from "../state/pieces";
import { pixelPoints } from "../plan/overlay/pixels";
import { usePlanWheel } from "../plan/wheel";
import { Grid, Underlay } from "./Backdrop";
import { ViewTools } from "../plan/ViewTools";
import { Advice } from "./Advice";
import { useDrawing } from "./context";
import type { RoomDrawing } from "./controller";
import { Handles } from "./Handles";
import { useDrawingKeys } from "./keys";
import { LengthField } from "./LengthField";
import { Lengths } from "./Lengths";
import { Guides, Pen } from "./PenLayer";
import { useDrawingPointer } from "./pointer";
import { ScaleField } from "./ScaleField";
import { Toolbar } from "./Toolbar";
import { Walls } from "./WallLayer";

function useSize(drawing: RoomDrawing, host: { current: HTMLDivElement | null }): void {
  useEffect(() => {
    const observer = new ResizeObserver(([entry]) => {
      drawing.width.value = entry!.contentRect.width;
      drawing.height.value = entry!.contentRect.height;
      drawing.fitUnlessMoved();
    });
    observer.observe(host.current!);
    return () => observer.disconnect();
  }, [drawing]);
}

// Of a name, pixels; what is narrower than its name has none.
const kLetter = 6;

// `below` is drawn on the floor: what stands in a room that is edited.
export function Canvas({ below }: { below: readonly Piece[] }) {
  const drawing = useDrawing(),
    host = useRef<HTMLDivElement>(null);
  useSize(drawing, host);
  usePlanWheel(drawing, host);
  const pointer = useDrawingPointer(drawing),
    keys = useDrawingKeys(drawing);
  useEffect(() => host.current!.focus({ preventScroll: true }), []);
  const cursor = useComputed(
    () =>
      drawing.gesture.value?.cursor ??
      (drawing.isSpaceDown.value
        ? "grab"
        : drawing.mode.value === "select"
          ? drawing.hovered.value
            ? "move"
            : "default"
          : "crosshair"),
  );
  useEffect(
    () =>
      cursor.subscribe((value) => {
        host.current!.style.cursor = value;
      }),
    [cursor],
  );
  const view = drawing.view.value;
  return (
    <div
      class="plan room-canvas"
      ref={host}
      tabIndex={0}
      role="application"
      {...keys}
      aria-label="Drawing of the room. Arrows and a typed length draw a wall; arrows move what is selected."
    >
      <svg
        class="plan-drawing"
        aria-hidden="true"
        ref={(element) => {
          drawing.element = element;
        }}
        {...pointer}
      >
        <Grid />
        <Underlay />
        <Walls />
        {below.map((piece) => {
          const { x, y } = toScreen(view, piece.pose), polygon = footprintOf(piece), { min, max } = boxOf(polygon);
          const isNamed = (max.x - min.x) * view.scale > piece.object.name.length * kLetter;
          return (
            <g key={piece.id}>
              <polygon class="room-piece" points={pixelPoints(view, polygon)} />
              {isNamed && <text class="room-piece-name" x={x} y={y + 4}>{piece.object.name}</text>}
            </g>
          );
        })}
        <Guides />
        <Pen />
        <Lengths />
        <Handles />
      </svg>
      <LengthField />
      <ScaleField />
      <Toolbar />
      <Advice />
      <ViewTools of={drawing} />
    </div>
  );
}
