// SPDX-License-Identifier: GPL-3.0-or-later
// Where one looks from in the room: at its door, on its floor, from a piece. Room frame R, z up.
import { toRoom } from "../geometry/footprint";
import { boxOf, edgesOf, inside } from "../geometry/polygon";
import { add, dot, left, middle, sub, times, unit, vec, type Vec } from "../geometry/vec";
import { OpeningKind, type Room } from "../gen/flair/v1/room_pb";
import { cornersOf, wallsOf, type Piece } from "../state/pieces";

export interface Stand {
  readonly eye: Vec & { readonly z: number };
  readonly target: Vec & { readonly z: number };
}

const kStanding = 1.6;
const kSitting = 1.15;
const kAbovePillow = 0.35;
const kFromPillow = 0.35;
// From the walls, and from the door that one has come in by.
const kMargin = 0.3;
const kStep = 0.8;

const at = ({ x, y }: Vec, z: number) => ({ x, y, z });

// The nearest place that is not in a wall.
export function keptInside(floor: readonly Vec[], p: Vec, margin = kMargin): Vec {
  const pushed = edgesOf(floor).reduce((spot, { a, b, inward }) => {
    const along = unit(sub(b, a)), where = dot(sub(spot, a), along), gap = dot(sub(spot, a), inward);
    const isBeside = where > -margin && where < dot(sub(b, a), along) + margin;
    return isBeside && gap < margin && gap > -1 ? add(spot, times(inward, margin - gap)) : spot;
  }, p);
  return inside(floor, pushed) ? pushed : p;
}

function middleOfFloor(floor: readonly Vec[]): Vec {
  const { min, max } = boxOf(floor), spot = middle(min, max);
  return inside(floor, spot) || floor.length === 0 ? spot : times(floor.reduce(add), 1 / floor.length);
}

// A step into the room from its first door, towards its middle.
export function atDoor(room: Room): Stand {
  const floor = cornersOf(room), to = middleOfFloor(floor);
  const door = room.openings.find(({ kind }) => kind === OpeningKind.DOOR);
  const wall = wallsOf(room).find(({ name }) => name === door?.wall);
  const along = wall && unit(sub(wall.b, wall.a));
  const from = wall && along && door
    ? add(add(wall.a, times(along, door.offsetM + door.widthM / 2)), times(left(along), kStep))
    : vec(to.x, to.y - 1);
  return { eye: at(keptInside(floor, from, 0.5), kStanding), target: at(to, 1.2) };
}

// Upright at a point, looking the way one looked.
export function onFloor(floor: readonly Vec[], point: Vec, ahead: Vec): Stand {
  const spot = keptInside(floor, point);
  return { eye: at(spot, kStanding), target: at(add(spot, unit(ahead)), kStanding - 0.1) };
}

// As one who lies in it, sits on it or at it, or stands before it.
export function fromPiece({ object, pose, size, z }: Piece, floor: readonly Vec[]): Stand {
  const front = size.depth / 2, ahead = (y: number) => toRoom(pose, vec(0, y));
  const words = object.category.split("_");
  if (words.includes("bed")) {
    const height = Math.min(object.heightM, 0.6) + kAbovePillow;
    return { eye: at(ahead(kFromPillow - front), z + height), target: at(ahead(front), z + height - 0.1) };
  }
  if (object.seat || words.some((word) => ["sofa", "armchair", "chair", "bench", "stool", "loveseat"].includes(word))) {
    return { eye: at(toRoom(pose, vec(0, 0)), kSitting), target: at(ahead(front + 1), kSitting - 0.08) };
  }
  if (object.satAt) return { eye: at(keptInside(floor, ahead(front + 0.3)), kSitting), target: at(ahead(-front), 0.95) };
  return { eye: at(keptInside(floor, ahead(front + 1)), kStanding), target: at(ahead(0), z + object.heightM * 0.6) };
}

// The wall that a piece hangs on.
export function wallBehind({ pose, size }: Piece, room: Room): string {
  const back = toRoom(pose, vec(0, -size.depth / 2));
  const ways = wallsOf(room).map(({ name, a, b }) => {
    const along = unit(sub(b, a)), where = dot(sub(back, a), along), long = dot(sub(b, a), along);
    const beside = Math.max(0, -where, where - long);
    return { name, away: Math.abs(dot(sub(back, a), left(along))) + beside };
  });
  return ways.reduce((best, one) => (one.away < best.away ? one : best), { name: "", away: 0.3 }).name;
}

// The walls that are seen from behind, and would hide the room.
export function wallsInTheWay(room: Room, eye: Vec): Set<string> {
  return new Set(wallsOf(room).filter(({ a, b }) => dot(sub(eye, a), left(unit(sub(b, a)))) < 0).map(({ name }) => name));
}
