// SPDX-License-Identifier: GPL-3.0-or-later
// What walls are called: by compass in an upright rectangle, else by number; names that they came with stay.
import { isUprightRectangle, wallsOf, type Sketch } from "./sketch";

const compass = (inward: { x: number; y: number }): string => {
  if (Math.abs(inward.x) > Math.abs(inward.y)) return inward.x > 0 ? "west" : "east";
  return inward.y > 0 ? "south" : "north";
};

// Key -> name, as docs/rooms.md says.
export function wallNamesOf(sketch: Sketch): Map<string, string> {
  const walls = wallsOf(sketch);
  const names = new Map<string, string>();
  if (isUprightRectangle(sketch) && walls.every(({ key }) => !sketch.wallNames[key])) {
    for (const { key, inward } of walls) names.set(key, compass(inward));
    return names;
  }
  const taken = new Set(walls.map(({ key }) => sketch.wallNames[key]).filter(Boolean));
  walls.forEach(({ key, index }) => {
    let name = sketch.wallNames[key] ?? "";
    for (let number = index + 1; !name; number += 1) if (!taken.has(`wall_${number}`)) name = `wall_${number}`;
    taken.add(name);
    names.set(key, name);
  });
  return names;
}

const isNumbered = /^wall_(\d+)$/;

// "north wall", "wall 3", "garden wall".
export function spokenWall(name: string): string {
  const number = isNumbered.exec(name)?.[1];
  if (number) return `wall ${number}`;
  const words = name.replace(/_/g, " ");
  return /wall/.test(words) ? words : `${words} wall`;
}

// "door 1" of "door_1".
export const spokenFixture = (id: string): string => id.replace(/_/g, " ");

// The ends of a wall as they lie on the screen: "left", "right", "upper", "lower".
export function endsOf(along: { x: number; y: number }): { start: string; end: string } {
  if (Math.abs(along.x) >= Math.abs(along.y))
    return along.x > 0 ? { start: "left", end: "right" } : { start: "right", end: "left" };
  return along.y > 0 ? { start: "lower", end: "upper" } : { start: "upper", end: "lower" };
}
