// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { kept } from "./kept";

const row = (key: string, isMissed: boolean) => ({ key, isMissed });
const list = (before: string[], ...rows: Array<{ key: string; isMissed: boolean }>) => listWith("", before, ...rows);
const listWith = (inHand: string, before: string[], ...rows: Array<{ key: string; isMissed: boolean }>) =>
  kept(before, rows, ({ key }) => key, ({ isMissed }) => isMissed, ({ key }) => key === inHand).map(({ key }) => key);

test("at first only what is wanted is shown", () => {
  assert.deepEqual(list([], row("a", true), row("b", false), row("c", true)), ["a", "c"]);
});

test("what was shown stays where it was; new ones follow", () => {
  assert.deepEqual(list(["c", "a"], row("a", true), row("b", true), row("c", true)), ["c", "a", "b"]);
});

test("what is wanted no more leaves, but for what is in hand", () => {
  assert.deepEqual(list(["c", "a"], row("a", true), row("c", false)), ["a"]);
  assert.deepEqual(listWith("c", ["c", "a"], row("a", true), row("c", false)), ["c", "a"]);
});

test("what is gone leaves", () => {
  assert.deepEqual(list(["a", "b"], row("b", true)), ["b"]);
});
