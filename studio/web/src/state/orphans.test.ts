// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { create } from "@bufbuild/protobuf";
import { ObjectKind } from "../gen/flair/v1/object_list_pb";
import { SolvedLayoutSchema } from "../gen/flair/v1/solved_layout_pb";
import { homeFor, orphansInWords, orphansOf, seatsAt, seatsInWords } from "./orphans";
import { piecesOf } from "./pieces";

const top = (id: string, category: string, heightM: number) =>
  ({ id, name: id, category, kind: ObjectKind.FLOOR, widthM: 1.2, depthM: 0.6, heightM });
const small = (id: string) =>
  ({ id, name: id, kind: ObjectKind.SURFACE, widthM: 0.3, depthM: 0.2, heightM: 0.3, hostId: "desk" });

const pieces = piecesOf(create(SolvedLayoutSchema, {
  graph: {
    objectList: {
      objects: [top("desk", "desk", 0.74), top("sofa", "sofa", 0.8), top("sideboard", "cabinet", 0.8),
        top("wardrobe", "wardrobe", 2.1), small("lamp"), small("monitor")],
    },
  },
  placements: [
    { objectId: "desk", xM: 1, yM: 1 }, { objectId: "sofa", xM: 1, yM: 2 }, { objectId: "sideboard", xM: 3, yM: 3 },
    { objectId: "wardrobe", xM: 1, yM: 3 },
    { objectId: "lamp", xM: 0.7, yM: 1, zM: 0.74 }, { objectId: "monitor", xM: 1.2, yM: 1, zM: 0.74 },
  ],
}));

test("what stood on a piece is named when it goes", () => {
  const orphans = orphansOf(pieces, ["desk"]);
  assert.deepEqual(orphans.map(({ id }) => id), ["lamp", "monitor"]);
  assert.equal(orphansInWords(orphans, [pieces.get("desk")!]), "The lamp and the monitor stood on the desk.");
  assert.deepEqual(orphansOf(pieces, ["desk", "lamp", "monitor"]), []);
});

test("it finds a place on the nearest top that is neither a seat nor too high", () => {
  const left = new Map([...pieces].filter(([id]) => id !== "desk"));
  const first = homeFor(left, pieces.get("lamp")!)!;
  assert.equal(first.host.id, "sideboard");
  assert.deepEqual([first.pose.x, first.pose.y, first.z], [3, 3, 0.8]);
  // The next one goes beside it.
  const lamp = { ...pieces.get("lamp")!, pose: first.pose, z: first.z };
  const second = homeFor(new Map(left).set("lamp", lamp), pieces.get("monitor")!)!;
  assert.ok(Math.abs(Math.abs(second.pose.x - 3) - 0.3) < 1e-9);
});

test("the chair of a desk that goes is told", () => {
  const room = piecesOf(create(SolvedLayoutSchema, {
    graph: { objectList: { objects: [
      { ...top("desk", "desk", 0.74), satAt: true },
      { ...top("office_chair", "chair", 1), name: "office chair", seat: true },
      { ...top("visitor", "chair", 1), seat: true },
    ] } },
    placements: [{ objectId: "desk", xM: 1, yM: 1 }, { objectId: "office_chair", xM: 1, yM: 1.5 }, { objectId: "visitor", xM: 3, yM: 1 }],
  }));
  const seats = seatsAt(room, ["desk"]);
  assert.equal(seatsInWords(seats), "The office chair stood at what is gone.");
  assert.deepEqual(seatsAt(room, ["desk", "office_chair"]), []);
});

test("so are the chairs on every side of a table", () => {
  const chair = (id: string) => ({ ...top(id, "chair", 0.9), name: "chair", widthM: 0.5, depthM: 0.5, seat: true });
  const room = piecesOf(create(SolvedLayoutSchema, {
    graph: { objectList: { objects: [
      { ...top("table", "dining_table", 0.75), widthM: 1.5, depthM: 0.9 }, chair("chair_1"), chair("chair_2"), chair("chair_3"),
    ] } },
    placements: [{ objectId: "table", xM: 2, yM: 2 }, { objectId: "chair_1", xM: 2, yM: 2.65 },
      { objectId: "chair_2", xM: 0.95, yM: 2 }, { objectId: "chair_3", xM: 2, yM: 3.5 }],
  }));
  assert.equal(seatsInWords(seatsAt(room, ["table"])), "Chair 1 and chair 2 stood at what is gone.");
});
