// SPDX-License-Identifier: GPL-3.0-or-later
// What walls without a name of their own ("wall_3") are called: by their side of the room, as WallName of room/scene/scene.cc
// calls them in the server's sentences.
import { areaText, lengthText, type Units } from "../app/units";
import { distance, left, sub, unit, type Vec } from "./vec";

export interface NamedWall {
  readonly name: string;
  readonly a: Vec;
  readonly b: Vec;
}

const isNumbered = /^wall_\d+$/;

// Rooms are at the left of their walls.
export function sideOf({ a, b }: NamedWall): string {
  const inward = left(unit(sub(b, a)));
  if (Math.abs(inward.y) > 0.5) return inward.y > 0 ? "south" : "north";
  return inward.x > 0.5 ? "west" : "east";
}

// Name -> "north wall", "1.20 m north wall"; only for walls that have but a number.
export function wallWords(walls: readonly NamedWall[], units: Units = "m"): Map<string, string> {
  const numbered = walls.filter(({ name }) => isNumbered.test(name));
  return new Map(numbered.map((wall) => {
    const side = sideOf(wall);
    const isAlone = numbered.filter((one) => sideOf(one) === side).length +
      walls.filter(({ name }) => name === side).length < 2;
    return [wall.name, isAlone ? `${side} wall` : `${lengthText(distance(wall.a, wall.b), units)} ${side} wall`];
  }));
}

// "wall_3", "the wall 3", "wall_3 in the north".
const kNumbered = /\b(?:the )?wall[_ ](\d+)(?: wall)?\b(?: in the (?:north|south|east|west)(?:-(?:east|west))?\b)?/g;
// "1.20 m", but no square metres.
const kMetres = /(?<![\d.])(\d+(?:\.\d+)?) m(?![\w²])/g;
const kSquareMetres = /(?<![\d.])(\d+(?:\.\d+)?) ?m(?:2\b|²)/g;

// A text of the server with the walls so called, and lengths and areas as the user writes them.
export function spoken(text: string, walls: ReadonlyMap<string, string>, units: Units = "m"): string {
  const named = text.replace(kNumbered, (all, number: string) => {
    const words = walls.get(`wall_${number}`);
    return words ? `the ${words}` : all;
  });
  if (units === "m") return named.replace(kSquareMetres, "$1 m²");
  return named.replace(kSquareMetres, (_, metres: string) => areaText(Number(metres), units))
    .replace(kMetres, (_, metres: string) => lengthText(Number(metres), units));
}

// What programs read of a note; the rest is for people.
const kForPrograms = /^(id|.*_ids?|sentence|types|kind|unit|fate|role)$/;

// The same for every text of a note.
export function spokenThroughout<T>(value: T, walls: ReadonlyMap<string, string>, units: Units = "m"): T {
  if (typeof value === "string") return spoken(value, walls, units) as T;
  if (Array.isArray(value)) return value.map((one) => spokenThroughout(one, walls, units)) as T;
  if (typeof value !== "object" || value === null) return value;
  return Object.fromEntries(Object.entries(value).map(([key, one]) =>
    [key, kForPrograms.test(key) ? one : spokenThroughout(one, walls, units)])) as T;
}
