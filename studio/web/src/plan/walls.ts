// SPDX-License-Identifier: GPL-3.0-or-later
// Walls and what is dragged: no piece goes into one, and what has its back at a wall is known by its wishes.
import { contains, corners, moved, toObject, type Pose, type Size } from "../geometry/footprint";
import { boxOf, edgesOf, inside } from "../geometry/polygon";
import { add, cross, distance, middle, nearestOnSegment, sub, times, turned, vec, type Vec } from "../geometry/vec";
import { heldInside } from "../geometry/wall_mount";
import type { ConstraintEdge } from "../gen/flair/v1/layout_graph_pb";

// Whether a wish, such as the handbook's for a bed, is that a piece has its back at a wall.
export function isForWall(edges: readonly ConstraintEdge[], id: string): boolean {
  return edges.some(({ type, arguments: given }) => {
    const textOf = (name: string) => given.find((one) => one.name === name)?.value?.value.value;
    return type === "against_wall" && textOf("object") === id && (textOf("side") ?? "back") === "back";
  });
}

// Out of a corner of the floor that reaches into the room, by the shorter way along its own sides.
function outOfCorner(pose: Pose, size: Size, corner: Vec): Pose {
  const kTouch = 1e-6;
  if (!contains(pose, { width: size.width - kTouch, depth: size.depth - kTouch }, corner)) return pose;
  const at = toObject(pose, corner);
  const aside = size.width / 2 - Math.abs(at.x), along = size.depth / 2 - Math.abs(at.y);
  const by = aside < along ? vec(at.x > 0 ? -aside : aside, 0) : vec(0, at.y > 0 ? -along : along);
  return moved(pose, turned(by, pose.theta));
}

// The piece at the nearest place where it is within the walls, turned as it is; of one that is larger than the room the
// middle is.
export function keptInside(pose: Pose, size: Size, floor: readonly Vec[]): Pose {
  const at = vec(pose.x, pose.y);
  const [first, ...others] = edgesOf(floor).map(({ a, b }) => nearestOnSegment(at, a, b));
  if (!first) return pose;
  const foot = others.reduce((best, one) => (distance(best, at) <= distance(one, at) ? best : one), first);
  // A hair within: what is just in a corner is beside none of its walls.
  const kHair = 1e-6, { min, max } = boxOf(floor);
  const { x, y } = add(foot, times(sub(middle(min, max), foot), kHair));
  let held = inside(floor, at) && distance(at, foot) > kHair ? pose : { x, y, theta: pose.theta };
  const reaching = floor.filter((corner, i) => {
    const before = floor[(i + floor.length - 1) % floor.length]!, after = floor[(i + 1) % floor.length]!;
    return cross(sub(corner, before), sub(after, corner)) < 0;
  });
  // Walls that meet at an angle push one after the other.
  for (let round = 0; round < 3; round += 1) {
    held = reaching.reduce<Pose>((one, corner) => outOfCorner(one, size, corner), heldInside(held, size, floor));
  }
  return inside(floor, vec(held.x, held.y)) ? held : { x, y, theta: pose.theta };
}

// The same for several at once, by the box around them: how far they are to be pushed back.
export function pushedBack(polygons: ReadonlyArray<readonly Vec[]>, floor: readonly Vec[]): Vec {
  const { min, max } = boxOf(polygons.flat());
  const pose = { x: (min.x + max.x) / 2, y: (min.y + max.y) / 2, theta: 0 };
  const size = { width: max.x - min.x, depth: max.y - min.y };
  if (corners(pose, size).every((corner) => inside(floor, corner))) return vec(0, 0);
  return sub(keptInside(pose, size, floor), pose);
}
