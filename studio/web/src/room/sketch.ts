// SPDX-License-Identifier: GPL-3.0-or-later
// A room while it is drawn: corners in the order in which walls run, and what is in the walls. Metres, x east, y north,
// any origin; walls are known by keys that stay when corners come and go.
import { area, boxOf } from "../geometry/polygon";
import { distance, dot, left, sub, unit, vec, type Vec } from "../geometry/vec";

export type Swing = "inward" | "outward" | "sliding" | "none";

export interface Corner extends Vec {
  // Key of the wall that runs from here to the next corner.
  readonly wall: string;
}

interface InWall {
  readonly id: string;
  readonly wall: string;
  // From the wall's first corner to the nearer end of an opening, or to the middle of a socket.
  readonly offset: number;
}

export interface Door extends InWall {
  readonly kind: "door";
  readonly width: number;
  readonly head: number;
  readonly swing: Swing;
  // The end that carries the hinges, along the wall.
  readonly hinge: "start" | "end";
  readonly angle: number;
}

export interface Window extends InWall {
  readonly kind: "window";
  readonly width: number;
  readonly sill: number;
  readonly head: number;
}

export interface Socket extends InWall {
  readonly kind: "socket";
  readonly height: number;
}

export type Fixture = Door | Window | Socket;

export interface Sketch {
  readonly corners: readonly Corner[];
  // False while its walls are being drawn: no wall runs from the last corner to the first.
  readonly isClosed: boolean;
  readonly fixtures: readonly Fixture[];
  readonly height: number;
  readonly roomType: string;
  // Names that walls came with, by key.
  readonly wallNames: Readonly<Record<string, string>>;
}

export interface WallLine {
  readonly key: string;
  readonly index: number;
  readonly a: Vec;
  readonly b: Vec;
  readonly along: Vec;
  // Into the room.
  readonly inward: Vec;
  readonly length: number;
}

export const emptySketch: Sketch = {
  corners: [],
  isClosed: false,
  fixtures: [],
  height: 2.6,
  roomType: "living room",
  wallNames: {},
};

export const widthOf = (fixture: Fixture): number => (fixture.kind === "socket" ? 0 : fixture.width);

export function wallsOf({ corners, isClosed }: Sketch): WallLine[] {
  const count = isClosed ? corners.length : corners.length - 1;
  const side = isClosed && area(corners) < 0 ? -1 : 1;
  return corners.slice(0, Math.max(count, 0)).map((a, index) => {
    const b = corners[(index + 1) % corners.length]!;
    const along = unit(sub(b, a)),
      n = left(along);
    return {
      key: a.wall,
      index,
      a: vec(a.x, a.y),
      b: vec(b.x, b.y),
      along,
      inward: vec(n.x * side, n.y * side),
      length: distance(a, b),
    };
  });
}

// A key that no wall has.
export function freeKey(corners: readonly Corner[]): string {
  const taken = new Set(corners.map((corner) => corner.wall));
  for (let number = 1; ; number += 1) if (!taken.has(`w${number}`)) return `w${number}`;
}

// "door_1", "door_2"... that nothing has.
export function freeFixtureId(fixtures: readonly Fixture[], kind: Fixture["kind"]): string {
  const taken = new Set(fixtures.map((fixture) => fixture.id));
  for (let number = 1; ; number += 1) if (!taken.has(`${kind}_${number}`)) return `${kind}_${number}`;
}

export function rectangle(width: number, depth: number, rest: Sketch = emptySketch): Sketch {
  const points = [vec(0, 0), vec(width, 0), vec(width, depth), vec(0, depth)];
  return {
    ...rest,
    corners: points.map((p, i) => ({ ...p, wall: `w${i + 1}` })),
    isClosed: true,
    fixtures: [],
    wallNames: {},
  };
}

export function extentOf({ corners }: Sketch): { width: number; depth: number } {
  if (corners.length === 0) return { width: 0, depth: 0 };
  const { min, max } = boxOf(corners);
  return { width: max.x - min.x, depth: max.y - min.y };
}

// The same room with its corners counter-clockwise; what is in the walls stays where it is.
export function counterClockwise(sketch: Sketch): Sketch {
  if (!sketch.isClosed || area(sketch.corners) >= 0) return sketch;
  const { corners } = sketch;
  const lengths = new Map(wallsOf(sketch).map(({ key, length }) => [key, length]));
  const reversed = corners.map((_, i) => {
    const at = corners.length - 1 - i;
    const { x, y } = corners[at]!;
    return { x, y, wall: corners[(at - 1 + corners.length) % corners.length]!.wall };
  });
  const fixtures = sketch.fixtures.map((fixture): Fixture => {
    const offset = (lengths.get(fixture.wall) ?? 0) - fixture.offset - widthOf(fixture);
    if (fixture.kind !== "door") return { ...fixture, offset };
    return { ...fixture, offset, hinge: fixture.hinge === "start" ? "end" : "start" };
  });
  return { ...sketch, corners: reversed, fixtures };
}

// Whether it is a rectangle whose sides run east and north.
export function isUprightRectangle(sketch: Sketch): boolean {
  const walls = wallsOf(sketch);
  return (
    sketch.isClosed &&
    walls.length === 4 &&
    walls.every(({ along }) => Math.min(Math.abs(along.x), Math.abs(along.y)) < 1e-6) &&
    walls.every(({ along }, i) => Math.abs(dot(along, walls[(i + 1) % 4]!.along)) < 1e-6)
  );
}
