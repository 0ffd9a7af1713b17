// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { create } from "@bufbuild/protobuf";
import { ObjectKind } from "../gen/flair/v1/object_list_pb";
import { SolvedLayoutSchema } from "../gen/flair/v1/solved_layout_pb";
import { freeId } from "./commands";
import { carrierOf, clicked, guestsOf, nameOf, piecesOf } from "./pieces";

const floor = { kind: ObjectKind.FLOOR, widthM: 1.2, depthM: 0.6, heightM: 0.74 };
const small = { kind: ObjectKind.SURFACE, widthM: 0.2, depthM: 0.2, heightM: 0.1 };
const pieces = piecesOf(
  create(SolvedLayoutSchema, {
    graph: {
      objectList: {
        objects: [
          { id: "desk", name: "desk", ...floor },
          { id: "tray", name: "tray", ...small, hostId: "desk" },
          { id: "cup_2", name: "cup", ...small, hostId: "tray" },
          { id: "rug", name: "rug", ...floor, walkOver: true, hostId: "desk" },
          { id: "lost", name: "lost", ...floor },
        ],
      },
    },
    placements: [
      { objectId: "desk", xM: 1, yM: 1 },
      { objectId: "tray", xM: 1.2, yM: 1, zM: 0.74 },
      { objectId: "cup_2", xM: 1.2, yM: 1, zM: 0.84 },
      { objectId: "rug", xM: 1, yM: 1 },
    ],
  }),
);

test("what has no place is no piece", () => {
  assert.deepEqual([...pieces.keys()], ["desk", "tray", "cup_2", "rug"]);
});

test("what stands on a piece goes with it, also what stands on that; a rug stays", () => {
  assert.deepEqual(guestsOf(pieces, ["desk"]), ["tray", "cup_2"]);
});

test("a press on what is carried means what carries it", () => {
  assert.equal(carrierOf(pieces, "cup_2"), "desk");
  assert.equal(carrierOf(pieces, "rug"), "rug");
});

test("names are numbered as ids are", () => {
  assert.equal(nameOf(pieces.get("cup_2")!.object), "cup 2");
});

test("a new id is none that is taken", () => {
  assert.equal(freeId(new Set(["desk"]), "Floor lamp"), "floor_lamp");
  assert.equal(freeId(new Set(["desk", "desk_2"]), "desk_2"), "desk_3");
});

test("a click means the piece itself, the next on the same spot what carries it, and so round", () => {
  const after = (selected: string[], isSameSpot = true) => clicked(pieces, "cup_2", new Set(selected), isSameSpot);
  assert.equal(after([]), "cup_2");
  assert.equal(after(["cup_2"]), "tray");
  assert.equal(after(["tray"]), "desk");
  assert.equal(after(["desk"]), "cup_2");
  assert.equal(after(["cup_2"], false), "cup_2");
  assert.equal(after(["cup_2", "desk"]), "cup_2");
});
