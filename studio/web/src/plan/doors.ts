// SPDX-License-Identifier: GPL-3.0-or-later
import { add, sub, times, turned, unit, type Vec } from "../geometry/vec";
import { DoorSwing, HingeSide, type Room } from "../gen/flair/v1/room_pb";
import { cornersOf } from "../state/pieces";

const kSteps = 12;

// The floor that the leaf of a door sweeps, counter-clockwise; undefined when there is no such door or it sweeps none.
export function doorSweep(room: Room, id: string): Vec[] | undefined {
  const door = room.openings.find((one) => one.id === id);
  const at = room.walls.findIndex((wall) => wall.name === door?.wall);
  const corners = cornersOf(room);
  if (!door?.leaf || at < 0 || door.leaf.swing !== DoorSwing.INWARD) return undefined;
  const from = corners[at]!, along = unit(sub(corners[(at + 1) % corners.length]!, from));
  const start = add(from, times(along, door.offsetM)), end = add(start, times(along, door.widthM));
  const isAtStart = door.leaf.hinge === HingeSide.START;
  const hinge = isAtStart ? start : end, closed = isAtStart ? sub(end, start) : sub(start, end);
  // The room is at the left of a wall, so a leaf hinged at its start turns counter-clockwise.
  const turn = (isAtStart ? 1 : -1) * (door.leaf.swingAngleRad || Math.PI / 2);
  const arc = Array.from({ length: kSteps + 1 }, (_, i) => add(hinge, turned(closed, (turn * i) / kSteps)));
  return isAtStart ? [hinge, ...arc] : [hinge, ...arc.reverse()];
}
