// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths on the drawing: of every wall, of the wall under way, and of the wall beside what is selected. A click lets
// one type another one.
import { figure } from "../app/units";
import { add, distance, middle, sub, times, unit, type Vec } from "../geometry/vec";
import { toScreen } from "../plan/view";
import { fixtureOf } from "./acts";
import { useDrawing } from "./context";
import { gapsOf } from "./fixtures";
import { kWallThickness } from "./shapes";
import type { Typed } from "./controller";
import { widthOf } from "./sketch";

const kShortestPixels = 26;

interface FigureProps {
  at: Vec;
  text: string;
  name?: string;
  open?: () => void;
}

function Figure({ at, text, name = "", open }: FigureProps) {
  const width = text.length * 6.4 + 12;
  return (
    <g
      class={`figure ${name}`}
      transform={`translate(${at.x.toFixed(1)} ${at.y.toFixed(1)})`}
      data-field={open ? "" : undefined}
      onClick={open}
    >
      <rect x={-width / 2} y={-10} width={width} height={20} rx={6} />
      <text y={4}>{text}</text>
    </g>
  );
}

// Where the length of a wall is written: outside of it.
export function wallFigureAt(a: Vec, b: Vec, outward: Vec, scale: number): Vec {
  return add(middle(a, b), times(outward, kWallThickness + (16 + 12 * Math.abs(outward.x)) / scale));
}

function WallFigures() {
  const drawing = useDrawing(),
    view = drawing.view.value,
    units = drawing.studio.settings.units.value;
  const isClosed = drawing.sketch.value.isClosed,
    selected = drawing.selection.value;
  return (
    <>
      {drawing.walls.value.map((wall) => {
        if (wall.length * view.scale < kShortestPixels) return null;
        const at = toScreen(view, wallFigureAt(wall.a, wall.b, times(wall.inward, -1), view.scale));
        const isSelected = selected?.kind === "wall" && selected.key === wall.key;
        return (
          <Figure
            key={wall.key}
            at={at}
            text={figure(wall.length, units)}
            name={isSelected ? "is-selected" : "is-quiet"}
            open={
              isClosed
                ? () => {
                    drawing.select({ kind: "wall", key: wall.key });
                    drawing.editing.value = { kind: "wall", key: wall.key };
                  }
                : undefined
            }
          />
        );
      })}
    </>
  );
}

export function PenFigure() {
  const drawing = useDrawing(),
    view = drawing.view.value,
    units = drawing.studio.settings.units.value;
  const last = drawing.sketch.value.corners.at(-1),
    pen = drawing.pen.value,
    typed = drawing.typed.value;
  if (!last || !pen || drawing.mode.value !== "pen") return null;
  const metres = distance(last, pen.at);
  if (metres * view.scale < kShortestPixels && !typed) return null;
  const d = unit(sub(pen.at, last)),
    aside = { x: -d.y, y: d.x };
  const at = toScreen(view, add(middle(last, pen.at), times(aside, (18 + 10 * Math.abs(aside.x)) / view.scale)));
  return typed ? (
    <Figure at={at} text={`${typed}▏`} name="is-typed" />
  ) : (
    <Figure at={at} text={figure(metres, units)} name="is-selected" />
  );
}

// The two ends of free wall beside a door, window or socket, inside the room.
function GapFigures() {
  const drawing = useDrawing(),
    view = drawing.view.value,
    units = drawing.studio.settings.units.value;
  const one = drawing.selection.value,
    ghost = drawing.ghost.value;
  const fixture = ghost ?? (one?.kind === "fixture" ? fixtureOf(drawing.sketch.value, one.id) : undefined);
  const wall = drawing.walls.value.find(({ key }) => key === fixture?.wall);
  if (!fixture || !wall) return null;
  const gaps = gapsOf(fixture, wall),
    inset = times(wall.inward, 24 / view.scale);
  const start = add(wall.a, times(wall.along, fixture.offset)),
    end = add(start, times(wall.along, widthOf(fixture)));
  const sides = [
    { side: "before", from: wall.a, to: start },
    { side: "behind", from: end, to: wall.b },
  ] as const;
  return (
    <>
      {sides.map(({ side, from, to }) => {
        if (gaps[side] * view.scale < 6) return null;
        const a = toScreen(view, add(from, inset)),
          b = toScreen(view, add(to, inset));
        const typed: Typed = { kind: "gap", id: fixture.id, side };
        return (
          <g key={side} class="clearance">
            <line x1={a.x} y1={a.y} x2={b.x} y2={b.y} />
            <Figure
              at={middle(a, b)}
              text={figure(gaps[side], units)}
              open={
                ghost
                  ? undefined
                  : () => {
                      drawing.editing.value = typed;
                    }
              }
            />
          </g>
        );
      })}
    </>
  );
}

export function Lengths() {
  return (
    <>
      <WallFigures />
      <GapFigures />
      <PenFigure />
    </>
  );
}
