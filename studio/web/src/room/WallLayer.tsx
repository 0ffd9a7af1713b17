// SPDX-License-Identifier: GPL-3.0-or-later
// Floor, walls and what is in them.
import { add, times } from "../geometry/vec";
import { pixelPoints } from "../plan/overlay/pixels";
import { toScreen } from "../plan/view";
import { useDrawing } from "./context";
import { sameSelection } from "./controller";
import { DrawnFixture } from "./DrawnFixture";
import { kWallThickness } from "./shapes";

export function Walls() {
  const drawing = useDrawing(),
    { corners, isClosed, fixtures } = drawing.sketch.value;
  const view = drawing.view.value,
    walls = drawing.walls.value;
  const selected = drawing.selection.value,
    hovered = drawing.hovered.value;
  const wrong = new Set(drawing.problems.value.flatMap(({ about }) => about));
  const points = pixelPoints(view, corners),
    thickness = kWallThickness * view.scale;
  const isTraced = drawing.picture.value !== undefined;
  const byKey = new Map(walls.map((wall) => [wall.key, wall]));
  return (
    <>
      {isClosed && (
        <>
          <mask
            id="room-outside"
            maskUnits="userSpaceOnUse"
            x={0}
            y={0}
            width={drawing.width.value}
            height={drawing.height.value}
          >
            <rect width={drawing.width.value} height={drawing.height.value} fill="#fff" />
            <polygon points={points} fill="#000" />
          </mask>
          <polygon class="room-walls" points={points} stroke-width={2 * thickness} mask="url(#room-outside)" />
        </>
      )}
      {isClosed && <polygon class={isTraced ? "room-floor is-traced" : "room-floor"} points={points} />}
      {!isClosed && corners.length > 0 && <polyline class="room-line" points={points} />}
      {walls.map((wall) => {
        const state = [
          selected?.kind === "wall" && selected.key === wall.key ? "is-selected" : "",
          hovered?.kind === "wall" && hovered.key === wall.key ? "is-hovered" : "",
          wrong.has(wall.key) ? "is-wrong" : "",
        ].join(" ");
        const a = toScreen(view, wall.a),
          b = toScreen(view, wall.b);
        const out = times(wall.inward, -kWallThickness);
        return (
          <g key={wall.key} class={`room-wall ${state}`} data-wall={wall.key}>
            {isClosed && (
              <polygon
                class="room-wall-band"
                points={pixelPoints(view, [wall.a, wall.b, add(wall.b, out), add(wall.a, out)])}
              />
            )}
            <line class="hit-line" x1={a.x} y1={a.y} x2={b.x} y2={b.y} />
          </g>
        );
      })}
      {[...fixtures, ...(drawing.ghost.value ? [drawing.ghost.value] : [])].map((fixture, i) => {
        const wall = byKey.get(fixture.wall);
        if (!wall) return null;
        const isGhost = i === fixtures.length;
        const one = { kind: "fixture", id: fixture.id } as const;
        const state = [
          isGhost ? "is-ghost" : "",
          sameSelection(selected, one) ? "is-selected" : "",
          sameSelection(hovered, one) ? "is-hovered" : "",
          wrong.has(fixture.id) ? "is-wrong" : "",
        ].join(" ");
        return <DrawnFixture key={isGhost ? "ghost" : fixture.id} fixture={fixture} wall={wall} state={state} />;
      })}
    </>
  );
}
