// SPDX-License-Identifier: GPL-3.0-or-later
// What keys, buttons and panels do to what is selected.
import { dot, type Vec } from "../geometry/vec";
import type { RoomDrawing, Selection } from "./controller";
import { newFixture, placed, withFixture, withoutFixture } from "./fixtures";
import { spokenFixture, spokenWallsOf } from "./names";
import { widthOf, type Fixture, type Sketch } from "./sketch";
import { withCornerAt, withCornerOn, withoutCorner, withWallMoved } from "./walls";

export function fixtureOf(sketch: Sketch, id: string): Fixture | undefined {
  return sketch.fixtures.find((one) => one.id === id);
}

export function cornerIndex(sketch: Sketch, key: string): number {
  return sketch.corners.findIndex(({ wall }) => wall === key);
}

export function nameOfWall({ sketch, studio }: RoomDrawing, key: string): string {
  return spokenWallsOf(sketch.value, studio.settings.units.value).get(key) ?? "wall";
}

export function setFixture(drawing: RoomDrawing, fixture: Fixture): void {
  drawing.commit(withFixture(drawing.sketch.peek(), fixture), `change ${spokenFixture(fixture.id)}`);
}

// A new one in the middle of a wall, or of the largest gap that it has.
export function addToWall(drawing: RoomDrawing, kind: Fixture["kind"], key: string): void {
  const sketch = drawing.sketch.peek(),
    wall = drawing.walls.peek().find((one) => one.key === key);
  if (!wall) return;
  const fixture = newFixture(sketch, kind, key, 0);
  const taken = sketch.fixtures
    .filter((one) => one.wall === key && one.kind !== "socket")
    .sort((a, b) => a.offset - b.offset);
  let at = 0,
    largest = { from: 0, to: 0 };
  for (const end of [
    ...taken.map((one) => [one.offset, one.offset + widthOf(one)] as const),
    [wall.length, wall.length] as const,
  ]) {
    if (end[0] - at > largest.to - largest.from) largest = { from: at, to: end[0] };
    at = Math.max(at, end[1]);
  }
  const offset = Math.max(0, (largest.from + largest.to - widthOf(fixture)) / 2);
  drawing.commit(withFixture(sketch, placed(fixture, undefined, wall, Math.round(offset * 100) / 100)), `add a ${kind}`);
  drawing.select({ kind: "fixture", id: fixture.id });
}

export function addCornerOn(drawing: RoomDrawing, index: number, offset: number): void {
  const next = withCornerOn(drawing.sketch.peek(), index, offset);
  drawing.commit(next, "add a corner");
  const added = next.corners[index + 1];
  if (added) drawing.select({ kind: "corner", key: added.wall });
}

// Removes it, says so, and offers it back as long as nothing else was done.
function removeAndTell(drawing: RoomDrawing, without: Sketch, name: string): void {
  drawing.commit(without, `remove ${name}`);
  const { now } = drawing.history.peek();
  drawing.studio.toasts.offer(`${name} is removed.`, [{
    label: "Put it back",
    run: () => {
      if (drawing.history.peek().now === now) drawing.undo();
      else drawing.studio.toasts.note("More was changed since. Undo goes back step by step (Ctrl Z).");
    },
  }]);
}

export function removeSelected(drawing: RoomDrawing): void {
  const one = drawing.selection.peek(),
    sketch = drawing.sketch.peek();
  if (!one) return;
  if (one.kind === "fixture") return removeAndTell(drawing, withoutFixture(sketch, one.id), spokenFixture(one.id));
  if (one.kind === "wall") return drawing.studio.toasts.note("A wall goes with one of its corners: remove that.");
  if (sketch.isClosed && sketch.corners.length <= 3)
    return drawing.studio.toasts.note("A room has at least three corners.");
  removeAndTell(drawing, withoutCorner(sketch, cornerIndex(sketch, one.key)), "a corner");
}

function nudged(sketch: Sketch, drawing: RoomDrawing, one: Selection, by: Vec): Sketch {
  if (one.kind === "corner") {
    const index = cornerIndex(sketch, one.key),
      at = sketch.corners[index]!;
    return withCornerAt(sketch, index, { x: at.x + by.x, y: at.y + by.y });
  }
  const walls = drawing.walls.peek();
  if (one.kind === "wall") {
    const wall = walls.find(({ key }) => key === one.key)!;
    return withWallMoved(sketch, wall.index, dot(by, { x: -wall.along.y, y: wall.along.x }));
  }
  const fixture = fixtureOf(sketch, one.id)!,
    wall = walls.find(({ key }) => key === fixture.wall);
  if (!wall) return sketch;
  const most = Math.max(0, wall.length - widthOf(fixture));
  const offset = Math.min(Math.max(fixture.offset + dot(by, wall.along), 0), most);
  return withFixture(sketch, { ...fixture, offset: Math.round(offset * 1e4) / 1e4 });
}

export function nudge(drawing: RoomDrawing, by: Vec): void {
  const one = drawing.selection.peek();
  if (one) drawing.commit(nudged(drawing.sketch.peek(), drawing, one, by), "nudge");
}
