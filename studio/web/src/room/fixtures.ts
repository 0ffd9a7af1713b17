// SPDX-License-Identifier: GPL-3.0-or-later
// Doors, windows and sockets along walls.
import { distance, dot, nearestOnSegment, sub, type Vec } from "../geometry/vec";
import { freeFixtureId, wallsOf, widthOf, type Fixture, type Sketch, type WallLine } from "./sketch";

export function newFixture(sketch: Sketch, kind: Fixture["kind"], wall: string, offset: number): Fixture {
  const id = freeFixtureId(sketch.fixtures, kind);
  if (kind === "door") {
    return {
      kind,
      id,
      wall,
      offset,
      width: 0.9,
      head: Math.min(2.05, sketch.height),
      swing: "inward",
      hinge: "start",
      angle: Math.PI / 2,
    };
  }
  if (kind === "window") return { kind, id, wall, offset, width: 1.4, sill: 0.9, head: Math.min(2.1, sketch.height) };
  return { kind, id, wall, offset, height: 0.3 };
}

// How much nearer to one end than to the other a door is that opens against that one, metres.
const kNearer = 0.05;

function nearerEnd(offset: number, width: number, length: number): "start" | "end" | undefined {
  const further = length - offset - width - offset;
  return Math.abs(further) < kNearer ? undefined : further > 0 ? "start" : "end";
}

// A fixture at another place. A door opens against the nearer end of the wall, not into the room, unless somebody has hung
// it otherwise: `from` is the wall that it was in, undefined for a new one.
export function placed(fixture: Fixture, from: WallLine | undefined, { key, length }: WallLine, offset: number): Fixture {
  const moved = { ...fixture, wall: key, offset };
  if (moved.kind !== "door" || fixture.kind !== "door") return moved;
  const was = from && nearerEnd(fixture.offset, fixture.width, from.length);
  const isOwn = was !== undefined && was !== fixture.hinge;
  return isOwn ? moved : { ...moved, hinge: nearerEnd(offset, fixture.width, length) ?? fixture.hinge };
}

// Doors and windows share a wall, sockets go below windows.
export const isInTheWay = (kind: Fixture["kind"], there: Fixture): boolean =>
  (kind === "socket") === (there.kind === "socket");

export interface Spot {
  readonly wall: WallLine;
  // Of the point on the wall that is nearest to the pointer.
  readonly along: number;
  readonly metres: number;
}

// The wall that a point is nearest to.
export function nearestWall(sketch: Sketch, p: Vec): Spot | undefined {
  let best: Spot | undefined;
  for (const wall of wallsOf(sketch)) {
    const at = nearestOnSegment(p, wall.a, wall.b),
      metres = distance(p, at);
    if (!best || metres < best.metres) best = { wall, along: dot(sub(at, wall.a), wall.along), metres };
  }
  return best;
}

const round = (metres: number, step: number) => Math.round(metres / step) * step;

// Where something that wide comes to stand when its middle is wanted at `along`: within the wall, at its ends or middle
// when nearer than `within`, else on whole multiples of `step`.
export function settledOffset(along: number, width: number, length: number, within: number, step: number): number {
  const most = Math.max(0, length - width);
  const wanted = Math.min(Math.max(along - width / 2, 0), most);
  const stops = [0, most, most / 2];
  const near = stops.find((stop) => Math.abs(stop - wanted) < within);
  const offset = near ?? Math.min(Math.max(round(wanted, step), 0), most);
  return Math.round(offset * 1e4) / 1e4;
}

export function withFixture(sketch: Sketch, fixture: Fixture): Sketch {
  const isKnown = sketch.fixtures.some(({ id }) => id === fixture.id);
  const fixtures = isKnown
    ? sketch.fixtures.map((one) => (one.id === fixture.id ? fixture : one))
    : [...sketch.fixtures, fixture];
  return { ...sketch, fixtures };
}

export function withoutFixture(sketch: Sketch, id: string): Sketch {
  return { ...sketch, fixtures: sketch.fixtures.filter((fixture) => fixture.id !== id) };
}

// Free wall before and behind it.
export function gapsOf(fixture: Fixture, wall: WallLine): { before: number; behind: number } {
  return { before: fixture.offset, behind: wall.length - fixture.offset - widthOf(fixture) };
}

// The end of an opening pulled to `along`; the other one stays.
export function withEndAt(fixture: Fixture, end: "start" | "end", along: number, length: number): Fixture {
  if (fixture.kind === "socket") return fixture;
  const kLeast = 0.2,
    stays = end === "start" ? fixture.offset + fixture.width : fixture.offset;
  const to = Math.round(Math.min(Math.max(along, 0), length) * 100) / 100;
  if (end === "start") {
    const offset = Math.min(to, stays - kLeast);
    return { ...fixture, offset: Math.round(offset * 1e4) / 1e4, width: Math.round((stays - offset) * 1e4) / 1e4 };
  }
  return { ...fixture, width: Math.round(Math.max(to - stays, kLeast) * 1e4) / 1e4 };
}
