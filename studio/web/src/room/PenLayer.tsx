// SPDX-License-Identifier: GPL-3.0-or-later
// The wall under way, lines that corners are caught by, and the two points of a known length.
import { toScreen } from "../plan/view";
import { useDrawing } from "./context";

export function Pen() {
  const drawing = useDrawing(),
    view = drawing.view.value,
    pen = drawing.pen.value;
  const { corners } = drawing.sketch.value,
    last = corners.at(-1),
    first = corners[0];
  if (drawing.mode.value !== "pen") return null;
  const at = pen && toScreen(view, pen.at),
    from = last && toScreen(view, last),
    start = first && toScreen(view, first);
  return (
    <g pointer-events="none">
      {pen?.inLine.map((corner) => {
        const p = toScreen(view, corner);
        return <line key={`${corner.x} ${corner.y}`} class="guide" x1={p.x} y1={p.y} x2={at!.x} y2={at!.y} />;
      })}
      {from && at && <line class="room-line is-pen" x1={from.x} y1={from.y} x2={at.x} y2={at.y} />}
      {corners.map((corner) => {
        const p = toScreen(view, corner);
        return <circle key={corner.wall} class="room-dot" cx={p.x} cy={p.y} r={3.5} />;
      })}
      {start && corners.length >= 3 && (
        <circle class={pen?.closes ? "room-close is-hit" : "room-close"} cx={start.x} cy={start.y} r={9} />
      )}
      {at && !pen.closes && <circle class="room-dot is-pen" cx={at.x} cy={at.y} r={4} />}
    </g>
  );
}

export function Guides() {
  const drawing = useDrawing(),
    view = drawing.view.value,
    points = drawing.scaling.value;
  const marks = points?.map((p) => toScreen(view, p)) ?? [];
  return (
    <g pointer-events="none">
      {drawing.lines.value.map(([p, q], i) => {
        const a = toScreen(view, p),
          b = toScreen(view, q);
        return <line key={i} class="guide" x1={a.x} y1={a.y} x2={b.x} y2={b.y} />;
      })}
      {marks.length === 2 && (
        <line class="guide is-wall" x1={marks[0]!.x} y1={marks[0]!.y} x2={marks[1]!.x} y2={marks[1]!.y} />
      )}
      {marks.map((at, i) => (
        <g key={i}>
          <circle class="room-scale" cx={at.x} cy={at.y} r={8} />
          <circle class="room-scale-dot" cx={at.x} cy={at.y} r={2} />
        </g>
      ))}
    </g>
  );
}
