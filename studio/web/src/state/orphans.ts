// SPDX-License-Identifier: GPL-3.0-or-later
// What stood on a piece that is gone, and which other piece could carry it.
import { contains, type Pose } from "../geometry/footprint";
import { distance, vec } from "../geometry/vec";
import { capital } from "../inspector/words";
import satOn from "./sat_on.json";
import { guestsOf, isSolid, theName, type Piece, type Pieces } from "./pieces";

const isOneOf = ({ object }: Piece, words: readonly string[]): boolean =>
  object.category.split("_").some((word) => words.includes(word));

// What is pulled up to a table.
export const isSeat = (piece: Piece): boolean => isOneOf(piece, satOn.pulled_up);
// Not for sitting or lying on: something may be put there, and knees may be below.
export const isTop = (piece: Piece): boolean => !isSeat(piece) && !isOneOf(piece, satOn.others);

// Tops between knee and chest.
const kLowest = 0.35;
const kHighest = 1.3;
const kFromEdge = 0.05;

// What the pieces carry; they themselves are none.
export function orphansOf(pieces: Pieces, removed: readonly string[]): Piece[] {
  return guestsOf(pieces, removed).map((id) => pieces.get(id)!);
}

// How far from what one sits at the middle of a seat is that is drawn up to it.
const kDrawnUp = 0.45;

// Seats that are drawn up to what one sits at, when that is removed and they are not.
export function seatsAt(pieces: Pieces, removed: readonly string[]): Piece[] {
  const places = removed.map((id) => pieces.get(id)!)
    .filter(({ object }) => object.satAt || object.category.endsWith("table"));
  const isAt = (seat: Piece) => places.some(({ pose, size }) =>
    contains(pose, { width: size.width + 2 * kDrawnUp, depth: size.depth + 2 * kDrawnUp }, vec(seat.pose.x, seat.pose.y)));
  return [...pieces.values()].filter((piece) =>
    piece.object.seat && !removed.includes(piece.id) && !piece.pinned && isAt(piece));
}

export interface Home {
  readonly host: Piece;
  readonly pose: Pose;
  readonly z: number;
}

// The nearest top that is large enough and has a free place, at its middle or at a quarter of its width.
export function homeFor(pieces: Pieces, orphan: Piece): Home | undefined {
  const reach = Math.max(orphan.size.width, orphan.size.depth) / 2;
  const hosts = [...pieces.values()].filter((host) => {
    const { heightM } = host.object;
    return host.id !== orphan.id && isSolid(host) && isTop(host) && heightM >= kLowest && heightM <= kHighest &&
      Math.min(host.size.width, host.size.depth) / 2 - kFromEdge >= reach;
  });
  const away = (host: Piece) => distance(vec(host.pose.x, host.pose.y), vec(orphan.pose.x, orphan.pose.y));
  for (const host of hosts.sort((a, b) => away(a) - away(b))) {
    const others = guestsOf(pieces, [host.id]).map((id) => pieces.get(id)!).filter((one) => one.id !== orphan.id);
    const { x, y, theta } = host.pose;
    for (const share of [0, 0.25, -0.25]) {
      const shift = share * host.size.width;
      const at = { x: x + Math.cos(theta) * shift, y: y + Math.sin(theta) * shift, theta };
      const isFree = others.every((one) =>
        distance(vec(at.x, at.y), vec(one.pose.x, one.pose.y)) >=
        reach + Math.max(one.size.width, one.size.depth) / 2 - 1e-6);
      const isOnTop = [-reach, reach].every((by) =>
        contains(host.pose, host.size, vec(at.x + Math.cos(theta) * by, at.y + Math.sin(theta) * by)));
      if (isFree && isOnTop) return { host, pose: at, z: host.object.heightM };
    }
  }
  return undefined;
}

const listed = (names: readonly string[]): string =>
  names.length < 2 ? names.join("") : `${names.slice(0, -1).join(", ")} and ${names.at(-1)}`;

const namesOf = (pieces: readonly Piece[]): string => listed(pieces.map(({ object }) => theName(object)));

// "The desk lamp and the monitor stood on the desk."
export const orphansInWords = (orphans: readonly Piece[], hosts: readonly Piece[]): string =>
  `${capital(namesOf(orphans))} stood on ${hosts.length === 1 ? namesOf(hosts) : "what is gone"}.`;

// "The office chair stood at what is gone."
export const seatsInWords = (seats: readonly Piece[]): string => `${capital(namesOf(seats))} stood at what is gone.`;
