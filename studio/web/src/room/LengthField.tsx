// SPDX-License-Identifier: GPL-3.0-or-later
// The field in which a length on the drawing is typed, over its figure.
import { useEffect, useRef } from "preact/hooks";
import { figure, parseLength } from "../app/units";
import { add, times, type Vec } from "../geometry/vec";
import { toScreen } from "../plan/view";
import { fixtureOf, nameOfWall, setFixture } from "./acts";
import { useDrawing } from "./context";
import type { RoomDrawing } from "./controller";
import { gapsOf } from "./fixtures";
import { wallFigureAt } from "./Lengths";
import { endsOf, withArticle } from "./names";
import { widthOf } from "./sketch";
import { withWallLength } from "./walls";

interface Asked {
  readonly at: Vec;
  readonly metres: number;
  readonly label: string;
  take(metres: number): void;
}

function askedOf(drawing: RoomDrawing): Asked | undefined {
  const typed = drawing.editing.value,
    sketch = drawing.sketch.value,
    { scale } = drawing.view.value;
  if (typed?.kind === "wall") {
    const wall = drawing.walls.value.find(({ key }) => key === typed.key);
    return (
      wall && {
        at: wallFigureAt(wall.a, wall.b, times(wall.inward, -1), scale),
        metres: wall.length,
        label: `Length of ${withArticle(nameOfWall(drawing, wall.key))}`,
        take: (metres) => drawing.commit(withWallLength(sketch, wall.index, metres), "change a length"),
      }
    );
  }
  const fixture = typed && fixtureOf(sketch, typed.id),
    wall = drawing.walls.value.find(({ key }) => key === fixture?.wall);
  if (!typed || !fixture || !wall) return undefined;
  const gaps = gapsOf(fixture, wall),
    width = widthOf(fixture);
  const spot = typed.side === "before" ? fixture.offset / 2 : wall.length - gaps.behind / 2;
  return {
    at: add(add(wall.a, times(wall.along, spot)), times(wall.inward, 24 / scale)),
    metres: gaps[typed.side],
    label: `From the ${endsOf(wall.along)[typed.side === "before" ? "start" : "end"]} end of the wall`,
    take: (metres) =>
      setFixture(drawing, { ...fixture, offset: typed.side === "before" ? metres : wall.length - width - metres }),
  };
}

export function LengthField() {
  const drawing = useDrawing(),
    input = useRef<HTMLInputElement>(null);
  const asked = askedOf(drawing),
    units = drawing.studio.settings.units.value;
  const at = asked && toScreen(drawing.view.value, asked.at);
  useEffect(() => {
    if (input.current && at)
      input.current.style.transform = `translate(${Math.round(at.x - 34)}px, ${Math.round(at.y - 13)}px)`;
  }, [at?.x, at?.y, asked?.label]);
  useEffect(() => input.current?.select(), [drawing.editing.value]);
  if (!asked) return null;
  const close = () => {
    drawing.editing.value = undefined;
    drawing.element?.parentElement?.focus({ preventScroll: true });
  };
  const take = () => {
    const metres = parseLength(input.current!.value, units);
    if (metres === undefined || metres < 0) return input.current!.setAttribute("aria-invalid", "true");
    close();
    if (Math.abs(metres - asked.metres) > 1e-4) asked.take(metres);
  };
  return (
    <input
      ref={input}
      class="clearance-field"
      defaultValue={figure(asked.metres, units)}
      aria-label={asked.label}
      onBlur={() => {
        drawing.editing.value = undefined;
      }}
      onKeyDown={(event) => {
        event.stopPropagation();
        if (event.key === "Enter") take();
        if (event.key === "Escape") close();
      }}
    />
  );
}
