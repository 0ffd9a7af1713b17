// SPDX-License-Identifier: GPL-3.0-or-later
// What lies below the drawing: a grid, and the picture that is traced.
import { vec } from "../geometry/vec";
import { toRoom, toScreen } from "../plan/view";
import { useDrawing } from "./context";

export function Grid() {
  const drawing = useDrawing(),
    view = drawing.view.value,
    width = drawing.width.value,
    height = drawing.height.value;
  if (width === 0) return null;
  const step = view.scale > 55 ? 0.5 : view.scale > 22 ? 1 : 5;
  const low = toRoom(view, vec(0, height)),
    high = toRoom(view, vec(width, 0));
  const marks = (from: number, to: number) =>
    Array.from(
      { length: Math.max(0, Math.floor(to / step) - Math.ceil(from / step) + 1) },
      (_, i) => (Math.ceil(from / step) + i) * step,
    );
  const name = (at: number) =>
    Math.abs(at / (step * 2) - Math.round(at / (step * 2))) < 1e-6 ? "room-grid is-strong" : "room-grid";
  return (
    <g aria-hidden="true">
      {marks(low.x, high.x).map((x) => {
        const at = toScreen(view, vec(x, 0)).x;
        return <line key={`x${x}`} class={name(x)} x1={at} x2={at} y1={0} y2={height} />;
      })}
      {marks(low.y, high.y).map((y) => {
        const at = toScreen(view, vec(0, y)).y;
        return <line key={`y${y}`} class={name(y)} y1={at} y2={at} x1={0} x2={width} />;
      })}
    </g>
  );
}

export function Underlay() {
  const drawing = useDrawing(),
    picture = drawing.picture.value,
    view = drawing.view.value;
  if (!picture) return null;
  const at = toScreen(view, picture.at),
    scale = picture.metresPerPixel * view.scale;
  return (
    <image
      href={picture.address}
      x={at.x}
      y={at.y}
      width={picture.widthPx * scale}
      height={picture.heightPx * scale}
      opacity={picture.opacity}
      preserveAspectRatio="none"
      pointer-events="none"
    />
  );
}
