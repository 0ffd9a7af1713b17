// SPDX-License-Identifier: GPL-3.0-or-later
// Where pieces stand when they are turned.
import { center, type Pose } from "../geometry/footprint";
import { boxOf } from "../geometry/polygon";
import { add, middle, sub, turned, type Vec } from "../geometry/vec";
import { heldInside } from "../geometry/wall_mount";
import { ObjectKind } from "../gen/flair/v1/object_list_pb";
import { footprintOf, type Piece, type Poses } from "./pieces";

// Around its own middle for one, around the middle of the box for several.
export function pivotOf(pieces: readonly Piece[]): Vec {
  if (pieces.length === 1) return center(pieces[0]!.pose);
  const { min, max } = boxOf(pieces.flatMap((piece) => footprintOf(piece)));
  return middle(min, max);
}

export function rotated(pieces: readonly Piece[], pivot: Vec, angle: number): Poses {
  return new Map(pieces.map(({ id, pose }): [string, Pose] => {
    const at = add(pivot, turned(sub(center(pose), pivot), angle));
    return [id, { x: at.x, y: at.y, theta: pose.theta + angle }];
  }));
}

// A lone piece does not turn into walls.
export function turnedInside(pieces: readonly Piece[], angle: number, floor: readonly Vec[]): Poses {
  const poses = rotated(pieces, pivotOf(pieces), angle), [only, ...others] = pieces;
  if (!only || others.length > 0 || only.object.kind !== ObjectKind.FLOOR) return poses;
  return new Map([[only.id, heldInside(poses.get(only.id)!, only.size, floor)]]);
}
