// SPDX-License-Identifier: GPL-3.0-or-later
// What the page needs to know of a layout's objects, and questions about them.
import { corners, contains, toObject, toRoom, type Pose, type Size } from "../geometry/footprint";
import { vec, wrapped, type Vec } from "../geometry/vec";
import type { NamedWall } from "../geometry/wall_names";
import { ObjectKind, type Object$ } from "../gen/flair/v1/object_list_pb";
import type { Placement } from "../gen/flair/v1/placement_pb";
import type { Room } from "../gen/flair/v1/room_pb";
import type { SolvedLayout } from "../gen/flair/v1/solved_layout_pb";

export type Poses = ReadonlyMap<string, Pose>;

export interface Piece {
  readonly id: string;
  readonly object: Object$;
  readonly size: Size;
  readonly pose: Pose;
  // Underside above the floor, metres.
  readonly z: number;
  readonly pinned: boolean;
}

export type Pieces = ReadonlyMap<string, Piece>;

// Those that stand somewhere, in the list's order.
export function piecesOf(layout: SolvedLayout | undefined): Pieces {
  const placements = new Map(layout?.placements.map((one) => [one.objectId, one]));
  const pinned = new Set(layout?.graph?.pinnedPlacements.map((one) => one.objectId));
  const pieces = new Map<string, Piece>();
  for (const object of layout?.graph?.objectList?.objects ?? []) {
    const at = placements.get(object.id);
    if (!at) continue;
    pieces.set(object.id, {
      id: object.id, object, size: { width: object.widthM, depth: object.depthM },
      pose: { x: at.xM, y: at.yM, theta: at.thetaRad }, z: at.zM, pinned: pinned.has(object.id),
    });
  }
  return pieces;
}

// "nightstand 2": the name, numbered where there are several.
export function nameOf(object: Object$): string {
  const number = /_(\d+)$/.exec(object.id)?.[1];
  return number && !object.name.endsWith(number) ? `${object.name} ${number}` : object.name;
}

// The same within a sentence: "the desk", but "nightstand 2".
export function theName(object: Object$): string {
  const name = nameOf(object);
  return /\d$/.test(name) ? name : `the ${name}`;
}

export const isOnFloor = (piece: Piece): boolean => piece.object.kind === ObjectKind.FLOOR;

// What one bumps into: no rugs, nothing on walls, ceilings and tables.
export const isSolid = (piece: Piece): boolean => isOnFloor(piece) && !piece.object.walkOver;

// The ids of all that stands on the pieces, which go where those go.
export function guestsOf(pieces: Pieces, hosts: Iterable<string>): string[] {
  const carried = new Set(hosts);
  const first = new Set(carried);
  for (let grown = true; grown; ) {
    grown = false;
    for (const piece of pieces.values()) {
      if (carried.has(piece.id) || piece.object.kind !== ObjectKind.SURFACE) continue;
      const host = hostOf(pieces, piece);
      if (host && carried.has(host)) {
        carried.add(piece.id);
        grown = true;
      }
    }
  }
  return [...carried].filter((id) => !first.has(id));
}

// What it stands on: its host by name, or whatever is below its middle.
export function hostOf(pieces: Pieces, guest: Piece): string {
  const named = pieces.get(guest.object.hostId);
  if (named && contains(named.pose, named.size, vec(guest.pose.x, guest.pose.y))) return named.id;
  for (const piece of pieces.values()) {
    if (piece.id === guest.id || piece.object.walkOver || piece.z + piece.object.heightM > guest.z + 0.05) continue;
    if (contains(piece.pose, piece.size, vec(guest.pose.x, guest.pose.y)) && guest.z > 0) return piece.id;
  }
  return "";
}

// The poses with those of all that stands on the pieces.
export function withGuests(pieces: Pieces, poses: Poses): Poses {
  const all = new Map<string, Pose>(poses);
  for (const [id, pose] of poses) {
    const host = pieces.get(id)!;
    for (const guest of guestsOf(pieces, [id])) {
      if (poses.has(guest)) continue;
      const was = pieces.get(guest)!.pose;
      const at = toRoom(pose, toObject(host.pose, vec(was.x, was.y)));
      all.set(guest, { x: at.x, y: at.y, theta: was.theta + pose.theta - host.pose.theta });
    }
  }
  return all;
}

// A piece, what carries it, what carries that...
export function carriersOf(pieces: Pieces, id: string): string[] {
  const chain = [id];
  for (let piece = pieces.get(id); piece?.object.kind === ObjectKind.SURFACE; ) {
    const host = pieces.get(hostOf(pieces, piece));
    if (!host || chain.includes(host.id)) break;
    chain.push(host.id);
    piece = host;
  }
  return chain;
}

// What a drag of a piece moves: the piece that carries it, as one moves an armchair and not its cushion.
export const carrierOf = (pieces: Pieces, id: string): string => carriersOf(pieces, id).at(-1)!;

// What a click on a piece means: itself; where one of it and its carriers is selected and the click is the next on the same
// spot, what carries that one, and after the last the piece itself again.
export function clicked(pieces: Pieces, id: string, selected: ReadonlySet<string>, isSameSpot: boolean): string {
  const chain = carriersOf(pieces, id), at = chain.findIndex((one) => selected.has(one));
  return isSameSpot && at >= 0 && selected.size === 1 ? chain[(at + 1) % chain.length]! : id;
}

export function footprintOf(piece: Piece, pose: Pose = piece.pose): Vec[] {
  return corners(pose, piece.size);
}

export function placementOf(piece: Piece, pose: Pose): Omit<Placement, "$typeName"> {
  return { objectId: piece.id, xM: pose.x, yM: pose.y, zM: piece.z, thetaRad: wrapped(pose.theta) };
}

export const cornersOf = (room: Room | undefined): Vec[] => room?.floor?.vertices.map((v) => vec(v.xM, v.yM)) ?? [];
export function wallsOf(room: Room | undefined): NamedWall[] {
  const corners = cornersOf(room);
  return corners.map((a, i) => ({ name: room?.walls[i]?.name ?? "", a, b: corners[(i + 1) % corners.length]! }));
}

export const floorOf = (layout: SolvedLayout | undefined): Vec[] => cornersOf(layout?.graph?.room);
