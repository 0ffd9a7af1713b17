// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong as things stand; while something is dragged, as they would stand.
import { create } from "@bufbuild/protobuf";
import { FindingKind, FindingSchema, type Finding } from "../gen/flair/v1/layout_metrics_pb";
import { corners, toRoom, type Pose } from "../geometry/footprint";
import { depthOf } from "../geometry/polygon";
import { distance, vec } from "../geometry/vec";
import type { OpenRoom } from "./open_room";
import { isSeat, isTop } from "./orphans";
import { footprintOf, isSolid, theName, type Piece, type Pieces, type Poses } from "./pieces";

// Less is no overlap but a touch.
const kTouch = 0.005;

const radius = ({ size }: Piece): number => Math.hypot(size.width, size.depth) / 2;

function sharedHeight(a: Piece, b: Piece): number {
  return Math.min(a.z + a.object.heightM, b.z + b.object.heightM) - Math.max(a.z, b.z);
}

// Knees are below the table as far as this, and so is the front of a seat.
const kKnees = 0.3;
const kLeastSeat = 0.1;

interface Standing {
  readonly piece: Piece;
  readonly pose: Pose;
}

// Whether only the front of the one, a seat, is below the other, as knees are.
function isPulledUp({ piece: seat, pose }: Standing, { piece: table, pose: at }: Standing): boolean {
  if (!isSeat(seat) || !isTop(table)) return false;
  const { width, depth } = seat.size, kept = Math.max(depth - kKnees, kLeastSeat);
  const rear = corners({ ...toRoom(pose, vec(0, (kept - depth) / 2)), theta: pose.theta }, { width, depth: kept });
  return depthOf(rear, footprintOf(table, at)) < kTouch;
}

// The server lets anything reach below anything that is as high as a table, as knees do; only seats may, below what is
// no seat itself. These are the overlaps that it therefore does not tell, among pieces that stand on the floor.
export function untoldOverlaps(pieces: Pieces, poses: Poses, told: readonly Finding[]): Finding[] {
  const pairOf = (a: string, b: string) => [a, b].sort().join(" ");
  const known = new Set(told.map(({ objectId, partnerId }) => pairOf(objectId, partnerId)));
  const solid = [...pieces.values()].filter(isSolid)
    .map((piece): Standing => ({ piece, pose: poses.get(piece.id) ?? piece.pose }));
  return solid.flatMap((one, i) => solid.slice(0, i).flatMap((two) => {
    const { piece } = one, { piece: other } = two;
    if (distance(one.pose, two.pose) >= radius(piece) + radius(other)) return [];
    const across = depthOf(footprintOf(piece, one.pose), footprintOf(other, two.pose));
    const amount = Math.min(across, sharedHeight(piece, other));
    if (amount < kTouch || isPulledUp(one, two) || isPulledUp(two, one)) return [];
    if (known.has(pairOf(piece.id, other.id))) return [];
    return [create(FindingSchema, {
      kind: FindingKind.OVERLAP, objectId: piece.id, partnerId: other.id, amount, unit: "m",
      message: `${theName(other.object)} and ${theName(piece.object)} overlap by ${amount.toFixed(2)} m`,
    })];
  }));
}

function toldFindings(room: OpenRoom): readonly Finding[] {
  const stored = room.layout.value?.metrics?.findings ?? [];
  const verdict = room.judging.verdict.value;
  if (!verdict) return stored;
  const isAsked = ({ objectId, partnerId }: Finding) => verdict.poses.has(objectId) || verdict.poses.has(partnerId);
  return [...stored.filter((finding) => !isAsked(finding)), ...verdict.findings];
}

const kNowhere: Poses = new Map();

export function findingsOf(room: OpenRoom): readonly Finding[] {
  const told = toldFindings(room);
  const poses = room.judging.verdict.value?.poses ?? kNowhere;
  return [...untoldOverlaps(room.pieces.value, poses, told), ...told];
}

// Faults of things in space, and that one gets to none or not into the room; other uses that are not met are sentences,
// and told there.
// A blocked door is told first.
export const faultsOf = (room: OpenRoom): Finding[] => findingsOf(room).filter(({ sentenceId }) => !sentenceId)
  .sort((a, b) => Number(b.kind === FindingKind.USE_NOT_MET) - Number(a.kind === FindingKind.USE_NOT_MET));
