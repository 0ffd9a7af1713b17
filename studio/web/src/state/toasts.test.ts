// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { afterEach, beforeEach, test } from "node:test";
import { Toasts } from "./toasts";

const { setTimeout } = globalThis;
let now = 0;
let waiting: Array<{ at: number; run(): void }> = [];

beforeEach(() => {
  now = 0;
  waiting = [];
  globalThis.setTimeout = ((run: () => void, milliseconds: number) =>
    waiting.push({ at: now + milliseconds, run })) as unknown as typeof setTimeout;
});
afterEach(() => { globalThis.setTimeout = setTimeout; });

function tick(milliseconds: number): void {
  now += milliseconds;
  for (let due; (due = waiting.find(({ at }) => at <= now)); ) {
    waiting = waiting.filter((one) => one !== due);
    due.run();
  }
}

test("what is told is a sentence", () => {
  const toasts = new Toasts();
  toasts.note("the desk is locked");
  assert.equal(toasts.latest.value?.text, "The desk is locked.");
  toasts.error("Is it there?");
  assert.equal(toasts.latest.value?.text, "Is it there?");
});

test("one is seen, the one before it comes back, and none goes while it is read", () => {
  const toasts = new Toasts();
  toasts.offer("Deleted.", [{ label: "Undo", run: () => {} }]);
  toasts.note("Saved.");
  tick(6000);
  assert.equal(toasts.latest.value?.text, "Deleted.");
  toasts.isHeld = true;
  tick(20000);
  assert.equal(toasts.latest.value?.text, "Deleted.");
  toasts.isHeld = false;
  tick(2000);
  assert.equal(toasts.latest.value, undefined);
});

test("while all are listed none goes, and the list ends with the last but one", () => {
  const toasts = new Toasts();
  toasts.error("One.");
  toasts.error("Two.");
  toasts.isListed.value = true;
  tick(13000);
  assert.equal(toasts.shown.value.length, 2);
  toasts.dismiss(toasts.latest.value!.id);
  assert.equal(toasts.isListed.value, false);
  tick(13000);
  assert.equal(toasts.latest.value, undefined);
});
