// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { vec } from "./vec";
import { spoken, spokenThroughout, wallWords } from "./wall_names";

const corners = [vec(0, 0), vec(5, 0), vec(5, 2), vec(3, 2), vec(3, 4), vec(0, 4)];
const walls = corners.map((a, i) => ({ name: `wall_${i + 1}`, a, b: corners[(i + 1) % corners.length]! }));
const words = wallWords(walls);

// As room/scene/room_test.cc says of the server.
test("walls are called by the side of the room that they are on, alike ones by their lengths", () => {
  assert.deepEqual([...words.values()], ["south wall", "2.00 m east wall", "2.00 m north wall",
    "2.00 m east wall", "3.00 m north wall", "west wall"]);
  const named = walls.map((wall, i) => (i === 4 ? { ...wall, name: "garden" } : wall));
  assert.equal(wallWords(named).get("wall_3"), "north wall");
  assert.equal(wallWords(walls, "ft").get("wall_3"), "6′ 7″ north wall");
  const slanted = wallWords([{ name: "wall_1", a: vec(0, 0), b: vec(2, 1) }, { name: "wall_2", a: vec(2, 1), b: vec(1, 3) }]);
  assert.deepEqual([...slanted.values()], ["south wall", "east wall"]);
  assert.equal(wallWords([{ ...walls[0]!, name: "garden" }]).size, 0);
});

test("texts of the server name them so", () => {
  assert.equal(spoken("against wall_5, 17 m2", words), "against the 3.00 m north wall, 17 m²");
  assert.equal(spoken("the wall_1 wall; wall_12", words), "the south wall; wall_12");
  assert.equal(spoken("a door in wall_5 in the north and a window", words), "a door in the 3.00 m north wall and a window");
});

test("what programs read of a note stays", () => {
  const note = { id: "wall_1", demands: [{ sentence: "The bed is at wall_1.", about_it: "at wall_1", edge_ids: ["wall_1"] }] };
  assert.deepEqual(spokenThroughout(note, words),
    { id: "wall_1", demands: [{ sentence: "The bed is at wall_1.", about_it: "at the south wall", edge_ids: ["wall_1"] }] });
});

test("who measures in feet reads feet", () => {
  assert.equal(spoken("1.2 m from wall_1 (20.2 m2), 0.9 metres", words, "ft"), "3′ 11″ from the south wall (217 sq ft), 0.9 metres");
});
