// SPDX-License-Identifier: GPL-3.0-or-later
// Between a sketch and the protocol's room.
import type { MessageInitShape } from "@bufbuild/protobuf";
import { boxOf } from "../geometry/polygon";
import { sub, vec, type Vec } from "../geometry/vec";
import {
  DoorSwing,
  HingeSide,
  OpeningKind,
  type Opening,
  type OpeningSchema,
  type Room,
  type RoomSchema,
} from "../gen/flair/v1/room_pb";
import { wallNamesOf } from "./names";
import { counterClockwise, emptySketch, type Door, type Fixture, type Sketch, type Swing } from "./sketch";

const swings: Record<Swing, DoorSwing> = {
  inward: DoorSwing.INWARD,
  outward: DoorSwing.OUTWARD,
  sliding: DoorSwing.SLIDING,
  none: DoorSwing.NONE,
};

function swingOf(swing: DoorSwing | undefined): Swing {
  return (Object.keys(swings) as Swing[]).find((name) => swings[name] === swing) ?? "inward";
}

export interface Drawn {
  readonly room: MessageInitShape<typeof RoomSchema>;
  // How far the sketch was moved so that its corner is at the origin.
  readonly shift: Vec;
}

const round = (metres: number) => Math.round(metres * 1e4) / 1e4;

function leafOf({ swing, hinge, angle }: Door) {
  return { swing: swings[swing], hinge: hinge === "start" ? HingeSide.START : HingeSide.END, swingAngleRad: angle };
}

function openingOf(
  fixture: Exclude<Fixture, { kind: "socket" }>,
  wall: string,
  known: Opening | undefined,
): MessageInitShape<typeof OpeningSchema> {
  const { id, offset, width, head } = fixture;
  const shape = {
    id,
    wall,
    offsetM: round(offset),
    widthM: round(width),
    headHeightM: head,
    description: known?.description ?? "",
  };
  if (fixture.kind === "window") return { ...shape, kind: OpeningKind.WINDOW, sillHeightM: fixture.sill };
  return { ...shape, kind: OpeningKind.DOOR, sillHeightM: 0, leaf: leafOf(fixture) };
}

// `before` is the room that is edited: what a sketch does not hold stays as it was.
export function roomOf(drawn: Sketch, title: string, before?: Room): Drawn {
  const sketch = counterClockwise(drawn);
  const { min } = boxOf(sketch.corners);
  const names = wallNamesOf(sketch);
  const known = new Map(before?.openings.map((one) => [one.id, one]));
  const room: MessageInitShape<typeof RoomSchema> = {
    roomType: sketch.roomType.trim().toLowerCase(),
    title,
    heightM: sketch.height,
    floor: {
      vertices: sketch.corners.map((corner) => sub(corner, min)).map(({ x, y }) => ({ xM: round(x), yM: round(y) })),
    },
    walls: sketch.corners.map(({ wall }) => ({ name: names.get(wall)! })),
    openings: sketch.fixtures.flatMap((one) =>
      one.kind === "socket" ? [] : [openingOf(one, names.get(one.wall)!, known.get(one.id))],
    ),
    sockets: sketch.fixtures.flatMap((one) =>
      one.kind === "socket"
        ? [{ id: one.id, wall: names.get(one.wall)!, offsetM: round(one.offset), heightM: one.height }]
        : [],
    ),
    diagnostics: before?.diagnostics ?? [],
  };
  return { room, shift: vec(-min.x || 0, -min.y || 0) };
}

export function sketchOf(room: Room): Sketch {
  const corners = room.floor?.vertices.map((v, i) => ({ x: v.xM, y: v.yM, wall: `w${i + 1}` })) ?? [];
  const keys = new Map(room.walls.map(({ name }, i) => [name, `w${i + 1}`]));
  const openings = room.openings.map((one): Fixture => {
    const shape = {
      id: one.id,
      wall: keys.get(one.wall) ?? "",
      offset: one.offsetM,
      width: one.widthM,
      head: one.headHeightM,
    };
    if (one.kind === OpeningKind.WINDOW) return { ...shape, kind: "window", sill: one.sillHeightM };
    const hinge = one.leaf?.hinge === HingeSide.END ? "end" : "start";
    return {
      ...shape,
      kind: "door",
      swing: swingOf(one.leaf?.swing),
      hinge,
      angle: one.leaf?.swingAngleRad || Math.PI / 2,
    };
  });
  const sockets = room.sockets.map((one): Fixture => ({
    kind: "socket",
    id: one.id,
    wall: keys.get(one.wall) ?? "",
    offset: one.offsetM,
    height: one.heightM,
  }));
  return {
    ...emptySketch,
    corners,
    isClosed: true,
    fixtures: [...openings, ...sockets],
    height: room.heightM,
    roomType: room.roomType,
    wallNames: Object.fromEntries(room.walls.map(({ name }, i) => [`w${i + 1}`, name])),
  };
}
