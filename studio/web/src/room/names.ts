// SPDX-License-Identifier: GPL-3.0-or-later
// What walls are called: by compass in an upright rectangle, else by number; names that they came with stay.
import type { Units } from "../app/units";
import { sideOf, wallWords } from "../geometry/wall_names";
import { isUprightRectangle, wallsOf, type Sketch } from "./sketch";

// Key -> name, as docs/rooms.md says.
export function wallNamesOf(sketch: Sketch): Map<string, string> {
  const walls = wallsOf(sketch);
  const names = new Map<string, string>();
  if (isUprightRectangle(sketch) && walls.every(({ key }) => !sketch.wallNames[key])) {
    for (const { key, a, b } of walls) names.set(key, sideOf({ name: "", a, b }));
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

// Key -> "north wall", "1.20 m north wall", "garden wall".
export function spokenWallsOf(sketch: Sketch, units: Units): Map<string, string> {
  const names = wallNamesOf(sketch);
  // While they are drawn, nobody knows at which side of them the room will be.
  const walls = sketch.isClosed ? wallsOf(sketch).map(({ key, a, b }) => ({ name: names.get(key)!, a, b })) : [];
  const words = wallWords(walls, units);
  return new Map([...names].map(([key, name]) => [key, words.get(name) ?? ownName(name)]));
}

// "the north wall", but "wall 3".
export const withArticle = (wall: string): string => (/^wall \d/.test(wall) ? wall : `the ${wall}`);

function ownName(name: string): string {
  const words = name.replace(/_/g, " ");
  return words.endsWith("wall") ? words : `${words} wall`;
}

// "door 1" of "door_1".
export const spokenFixture = (id: string): string => id.replace(/_/g, " ");

// The ends of a wall by the compass: "west", "east", "north", "south".
export function endsOf(along: { x: number; y: number }): { start: string; end: string } {
  if (Math.abs(along.x) >= Math.abs(along.y))
    return along.x > 0 ? { start: "west", end: "east" } : { start: "east", end: "west" };
  return along.y > 0 ? { start: "south", end: "north" } : { start: "north", end: "south" };
}
