// SPDX-License-Identifier: GPL-3.0-or-later
// What walls without a name of their own ("wall_3") are called: by the point of the compass that they lie at.
import { areaText, lengthText, type Units } from "../app/units";
import { pointOf } from "./compass";
import { distance, left, sub, times, type Vec } from "./vec";

export interface NamedWall {
  readonly name: string;
  readonly a: Vec;
  readonly b: Vec;
}

const isNumbered = /^wall_\d+$/;
const kAlike = 0.01;

const lengthOf = ({ a, b }: NamedWall): number => distance(a, b);
// Rooms are at the left of their walls.
const sideOf = ({ a, b }: NamedWall): string => pointOf(times(left(sub(b, a)), -1));

function told(wall: NamedWall, alike: readonly NamedWall[]): string {
  const side = sideOf(wall), length = lengthOf(wall);
  const others = alike.filter((one) => one !== wall);
  if (others.length === 0) return `${side} wall`;
  const differs = others.every((one) => Math.abs(lengthOf(one) - length) > kAlike);
  if (differs && others.every((one) => lengthOf(one) > length)) return `${others.length > 1 ? "shortest" : "shorter"} ${side} wall`;
  if (differs && others.every((one) => lengthOf(one) < length)) return `${others.length > 1 ? "longest" : "longer"} ${side} wall`;
  return `${side} wall of ${length.toFixed(2)} m${differs ? "" : ` (${wall.name.replace("wall_", "")})`}`;
}

// Name -> "north wall", "shorter north wall", "north wall of 1.20 m"; only for walls that have but a number.
export function wallWords(walls: readonly NamedWall[]): Map<string, string> {
  const alikeOf = (wall: NamedWall) => walls.filter((one) => sideOf(one) === sideOf(wall));
  return new Map(walls.filter(({ name }) => isNumbered.test(name)).map((wall) => [wall.name, told(wall, alikeOf(wall))]));
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
