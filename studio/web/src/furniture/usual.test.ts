// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { usualNames } from "./usual_names";

test("a kind of room begins with what stands in it, also under a longer or another name", () => {
  assert.equal(usualNames("bedroom")[0], "double bed");
  assert.equal(usualNames("master bedroom")[0], "double bed");
  assert.equal(usualNames("living_room")[0], "sofa");
  assert.equal(usualNames("study")[0], "desk");
  assert.deepEqual(usualNames("bridge"), []);
});
