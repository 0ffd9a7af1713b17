// SPDX-License-Identifier: GPL-3.0-or-later
// Drags of corners, walls, openings and their ends; alt lets them go anywhere.
import { add, dot, sub, times, type Vec } from "../geometry/vec";
import { kDragStart, kSnapPixels, type Gesture } from "../plan/gesture";
import { panned } from "../plan/view";
import { cornerIndex, fixtureOf } from "./acts";
import type { RoomDrawing, Selection } from "./controller";
import { nearestWall, placed, settledOffset, withEndAt, withFixture } from "./fixtures";
import { spokenFixture } from "./names";
import { settledCorner } from "./pen";
import { widthOf, type Sketch } from "./sketch";
import { withCornerAt, withWallMoved } from "./walls";

const kStep = 0.05;
const kFine = 0.01;
const kGhostReach = 90;

// Shows what `change` makes of the sketch, and keeps it on release. A press without a move selects only.
function dragGesture(
  drawing: RoomDrawing,
  start: PointerEvent,
  selection: Selection,
  label: string,
  change: (sketch: Sketch, event: PointerEvent) => { sketch: Sketch; lines?: ReadonlyArray<readonly [Vec, Vec]> },
): Gesture {
  const before = drawing.sketch.peek();
  drawing.select(selection);
  let after: Sketch | undefined;
  return {
    cursor: "move",
    move(event) {
      if (!after && Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY) < kDragStart) return;
      const { sketch, lines } = change(before, event);
      after = sketch;
      drawing.preview(sketch, lines);
    },
    end() {
      if (after) drawing.commit(after, label);
      else drawing.abandon();
    },
    cancel() {
      drawing.abandon();
    },
  };
}

export function dragCorner(drawing: RoomDrawing, start: PointerEvent, key: string): Gesture {
  const index = cornerIndex(drawing.sketch.peek(), key);
  return dragGesture(drawing, start, { kind: "corner", key }, "move a corner", (sketch, event) => {
    const others = sketch.corners.filter((_, i) => i !== index);
    const options = { within: drawing.metresOf(kSnapPixels), isFree: event.altKey, step: kStep };
    const { at, inLine } = settledCorner(others, drawing.pointOf(event), options);
    return { sketch: withCornerAt(sketch, index, at), lines: inLine.map((corner) => [corner, at] as const) };
  });
}

// In line with corners of other walls, else in steps.
function settledShift(
  sketch: Sketch,
  corner: Vec,
  n: Vec,
  wanted: number,
  within: number,
  isFree: boolean,
): { by: number; of?: Vec } {
  if (isFree) return { by: Math.round(wanted / kFine) * kFine };
  const near = sketch.corners
    .map((c) => ({ c, d: dot(sub(c, corner), n) }))
    .filter(({ d }) => Math.abs(d) > 1e-6 && Math.abs(d - wanted) < within)
    .sort((a, b) => Math.abs(a.d - wanted) - Math.abs(b.d - wanted))[0];
  return near ? { by: near.d, of: near.c } : { by: Math.round(wanted / kStep) * kStep };
}

export function dragWall(drawing: RoomDrawing, start: PointerEvent, key: string): Gesture {
  const wall = drawing.walls.peek().find((one) => one.key === key)!;
  const n = { x: -wall.along.y, y: wall.along.x },
    from = drawing.pointOf(start);
  return dragGesture(drawing, start, { kind: "wall", key }, "move a wall", (sketch, event) => {
    const wanted = dot(sub(drawing.pointOf(event), from), n);
    const { by, of } = settledShift(sketch, wall.a, n, wanted, drawing.metresOf(kSnapPixels), event.altKey);
    return { sketch: withWallMoved(sketch, wall.index, by), lines: of ? [[of, add(wall.a, times(n, by))]] : [] };
  });
}

export function dragFixture(drawing: RoomDrawing, start: PointerEvent, id: string): Gesture {
  const fixture = fixtureOf(drawing.sketch.peek(), id)!;
  const wall = drawing.walls.peek().find(({ key }) => key === fixture.wall);
  const middle = fixture.offset + widthOf(fixture) / 2;
  // Where it was taken, from its middle.
  const grab = wall ? dot(sub(drawing.pointOf(start), wall.a), wall.along) - middle : 0;
  return dragGesture(drawing, start, { kind: "fixture", id }, `move ${spokenFixture(id)}`, (sketch, event) => {
    const spot = nearestWall(sketch, drawing.pointOf(event));
    if (!spot) return { sketch };
    const along = spot.wall.key === fixture.wall ? spot.along - grab : spot.along;
    const within = event.altKey ? 0 : drawing.metresOf(kSnapPixels);
    const offset = settledOffset(along, widthOf(fixture), spot.wall.length, within, event.altKey ? kFine : kStep);
    return { sketch: withFixture(sketch, placed(fixture, wall, spot.wall, offset)) };
  });
}

export function dragEnd(drawing: RoomDrawing, start: PointerEvent, id: string, end: "start" | "end"): Gesture {
  const fixture = fixtureOf(drawing.sketch.peek(), id)!;
  const wall = drawing.walls.peek().find(({ key }) => key === fixture.wall)!;
  return dragGesture(drawing, start, { kind: "fixture", id }, `widen ${spokenFixture(id)}`, (sketch, event) => {
    const along = dot(sub(drawing.pointOf(event), wall.a), wall.along),
      step = event.altKey ? kFine : kStep;
    return { sketch: withFixture(sketch, withEndAt(fixture, end, Math.round(along / step) * step, wall.length)) };
  });
}

export function panGesture(drawing: RoomDrawing, start: PointerEvent, click?: () => void): Gesture {
  const before = drawing.view.peek();
  let isMoved = false;
  return {
    cursor: "grabbing",
    move(event) {
      const by = { x: event.clientX - start.clientX, y: event.clientY - start.clientY };
      isMoved ||= Math.hypot(by.x, by.y) >= kDragStart;
      if (isMoved) drawing.setView(panned(before, by));
    },
    end() {
      if (!isMoved) click?.();
    },
    cancel() {
      drawing.view.value = before;
    },
  };
}

// Where the tool in hand would put a new one; nowhere when no wall is near.
export function ghostAt(
  drawing: RoomDrawing,
  fixture: Parameters<typeof withFixture>[1],
  event: PointerEvent,
): typeof fixture | undefined {
  const spot = nearestWall(drawing.sketch.peek(), drawing.pointOf(event));
  if (!spot || spot.metres > drawing.metresOf(kGhostReach)) return undefined;
  const within = event.altKey ? 0 : drawing.metresOf(kSnapPixels);
  const offset = settledOffset(spot.along, widthOf(fixture), spot.wall.length, within, event.altKey ? kFine : kStep);
  return placed(fixture, undefined, spot.wall, offset);
}
