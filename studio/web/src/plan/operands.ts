// SPDX-License-Identifier: GPL-3.0-or-later
// What a constraint is about besides its object: pieces, walls, openings, sockets.
import { middleOf, type Pose, type Side } from "../geometry/footprint";
import { edgesOf } from "../geometry/polygon";
import { add, distance, length, nearestOnSegment, sub, times, unit, type Vec } from "../geometry/vec";
import type { ConstraintEdge } from "../gen/flair/v1/layout_graph_pb";
import { OpeningKind, type Room } from "../gen/flair/v1/room_pb";
import { cornersOf, footprintOf, type Piece, type Pieces } from "../state/pieces";

export interface Link {
  // Of the constraint, and of the piece it is about.
  readonly edgeId: string;
  readonly from: Vec;
  readonly to: Vec;
  // A piece, a wall or an opening.
  readonly target: string;
}

function textsOf(edge: ConstraintEdge): Map<string, string> {
  return new Map(
    edge.arguments.flatMap(({ name, value }) => (value?.value.case === "text" ? [[name, value.value.value]] : [])),
  );
}

// Ids of the pieces that an edge names, the one it is about first.
export function piecesNamed(edge: ConstraintEdge, pieces: Pieces): string[] {
  const ids = edge.arguments.flatMap(({ value }) => {
    if (value?.value.case === "text") return [value.value.value];
    return value?.value.case === "texts" ? value.value.value.items : [];
  });
  return ids.filter((id) => pieces.has(id));
}

function wallSegment(room: Room, name: string): [Vec, Vec] | undefined {
  const at = room.walls.findIndex((wall) => wall.name === name);
  const corners = cornersOf(room);
  return at < 0 ? undefined : [corners[at]!, corners[(at + 1) % corners.length]!];
}

function along(room: Room, wall: string, offset: number): Vec | undefined {
  const segment = wallSegment(room, wall);
  return segment && add(segment[0], times(unit(sub(segment[1], segment[0])), offset));
}

// Segments of what a word such as "window", "door_1", "socket" or "north" may mean.
function segmentsOf(room: Room, word: string): Array<{ id: string; a: Vec; b: Vec }> {
  const wall = wallSegment(room, word);
  if (wall) return [{ id: word, a: wall[0], b: wall[1] }];
  const openings = room.openings.filter(({ id, kind }) => id === word
    || (word === "window" && kind === OpeningKind.WINDOW) || (word === "door" && kind === OpeningKind.DOOR));
  const sockets = room.sockets.filter(({ id }) => id === word || word === "socket");
  return [
    ...openings.map(({ id, wall: on, offsetM, widthM }) => ({
      id,
      a: along(room, on, offsetM),
      b: along(room, on, offsetM + widthM),
    })),
    ...sockets.map(({ id, wall: on, offsetM }) => ({ id, a: along(room, on, offsetM), b: along(room, on, offsetM) })),
  ].flatMap(({ id, a, b }) => (a && b ? [{ id, a, b }] : []));
}

// The shortest way between a polygon and a segment, from the polygon.
function shortest(polygon: readonly Vec[], a: Vec, b: Vec): [Vec, Vec] {
  const pairs: Array<[Vec, Vec]> = [
    ...polygon.map((p): [Vec, Vec] => [p, nearestOnSegment(p, a, b)]),
    ...edgesOf(polygon).flatMap((edge): Array<[Vec, Vec]> =>
      [[nearestOnSegment(a, edge.a, edge.b), a], [nearestOnSegment(b, edge.a, edge.b), b]]),
  ];
  // Of equal ways the middle one, as between two parallel sides.
  const least = Math.min(...pairs.map(([p, q]) => distance(p, q)));
  const best = pairs.filter(([p, q]) => distance(p, q) < least + 1e-6);
  const mean = (pick: 0 | 1) => times(best.map((pair) => pair[pick]).reduce(add), 1 / best.length);
  return [mean(0), mean(1)];
}

function between(a: readonly Vec[], b: readonly Vec[]): [Vec, Vec] {
  return edgesOf(b).map((edge) => shortest(a, edge.a, edge.b))
    .reduce((best, one) => (length(sub(one[1], one[0])) < length(sub(best[1], best[0])) - 1e-6 ? one : best));
}

function toNearestWall(room: Room, piece: Piece, pose: Pose, side: Side): [Vec, Vec] | undefined {
  const from = middleOf(pose, piece.size, side);
  const ways = edgesOf(cornersOf(room)).map(({ a, b }): [Vec, Vec] => [from, nearestOnSegment(from, a, b)]);
  return ways.length === 0 ? undefined
    : ways.reduce((best, one) => (distance(...one) < distance(...best) ? one : best));
}

// Lines from the piece that the edge is about to each of its operands.
export function linksOf(
  edge: ConstraintEdge,
  room: Room,
  pieces: Pieces,
  poseOf: (id: string) => Pose | undefined,
): Link[] {
  const [subject, ...others] = piecesNamed(edge, pieces);
  const piece = subject ? pieces.get(subject) : undefined;
  const pose = subject ? poseOf(subject) : undefined;
  if (!piece || !pose) return [];
  const own = footprintOf(piece, pose);
  const link = (target: string, [from, to]: [Vec, Vec]): Link => ({ edgeId: edge.id, from, to, target });
  const toPieces = others.flatMap((id) => {
    const other = pieces.get(id)!, at = poseOf(id);
    return at ? [link(id, between(own, footprintOf(other, at)))] : [];
  });
  const texts = textsOf(edge);
  // "wall_2|wall_4" is either wall.
  const toRoom = [...texts.values()].flatMap((words) => {
    const ways = words.split("|").flatMap((word) => segmentsOf(room, word)).map(({ id, a, b }) => ({ id, way: shortest(own, a, b) }));
    if (ways.length === 0) return [];
    const nearest = ways.reduce((best, one) => (distance(...one.way) < distance(...best.way) ? one : best));
    return [link(nearest.id, nearest.way)];
  });
  if (toPieces.length + toRoom.length > 0 || !/wall|corner/.test(edge.type)) return [...toPieces, ...toRoom];
  const side = (texts.get("side") || "back") as Side;
  const wall = ["front", "left", "back", "right"].includes(side) && toNearestWall(room, piece, pose, side);
  return wall ? [link("wall", wall)] : [];
}
