// SPDX-License-Identifier: GPL-3.0-or-later
// What corners and ends of openings are taken by.
import { add, middle, times, type Vec } from "../geometry/vec";
import { toScreen } from "../plan/view";
import { addCornerOn, fixtureOf } from "./acts";
import { useDrawing } from "./context";
import { kWallThickness, spanOf } from "./shapes";

function Square({
  at,
  name,
  corner,
  end,
  cursor,
}: {
  at: Vec;
  name: string;
  corner?: string;
  end?: string;
  cursor?: string;
}) {
  return (
    <g class={`grip ${name}`} data-corner={corner} data-end={end} data-cursor={cursor}>
      <circle class="hit" cx={at.x} cy={at.y} r={13} />
      <rect x={at.x - 4.5} y={at.y - 4.5} width={9} height={9} rx={2} />
    </g>
  );
}

export function Handles() {
  const drawing = useDrawing(),
    view = drawing.view.value,
    sketch = drawing.sketch.value,
    one = drawing.selection.value;
  if (!sketch.isClosed || drawing.mode.value !== "select") return null;
  const wall = one?.kind === "wall" ? drawing.walls.value.find(({ key }) => key === one.key) : undefined;
  const fixture = one?.kind === "fixture" ? fixtureOf(sketch, one.id) : undefined;
  const host =
    fixture && fixture.kind !== "socket" ? drawing.walls.value.find(({ key }) => key === fixture.wall) : undefined;
  const span = host && fixture && fixture.kind !== "socket" ? spanOf(fixture, host) : undefined;
  const half = wall && toScreen(view, add(middle(wall.a, wall.b), times(wall.inward, -kWallThickness / 2)));
  return (
    <>
      {sketch.corners.map((corner) => (
        <Square
          key={corner.wall}
          at={toScreen(view, corner)}
          corner={corner.wall}
          name={one?.kind === "corner" && one.key === corner.wall ? "is-corner is-chosen" : "is-corner"}
        />
      ))}
      {half && wall!.length * view.scale > 60 && (
        <g
          class="room-add"
          data-field=""
          onClick={() => addCornerOn(drawing, wall!.index, Math.round(wall!.length * 50) / 100)}
        >
          <title>Add a corner here</title>
          <circle cx={half.x} cy={half.y} r={9} />
          <path d={`M${half.x - 4} ${half.y}h8M${half.x} ${half.y - 4}v8`} />
        </g>
      )}
      {span && <Square at={toScreen(view, span.start)} end="start" name="" />}
      {span && <Square at={toScreen(view, span.end)} end="end" name="" />}
    </>
  );
}
