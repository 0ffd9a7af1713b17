// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { create } from "@bufbuild/protobuf";
import { signal } from "@preact/signals";
import type { Clients } from "../api/clients";
import { DocumentSchema, type Document } from "../gen/flair/v1/studio_service_pb";
import { VariantSearch } from "./search";

// A room, and a server that answers when it is told to.
function begun() {
  const document = signal<Document>(create(DocumentSchema, { id: "d", revision: 3n, layoutId: "a" }));
  const told: string[] = [], found: Document[] = [];
  let answer = (_: { document: Document }) => {};
  const findVariants = (_: unknown, { signal: given }: { signal: AbortSignal }) =>
    new Promise((done, failed) => {
      answer = done;
      given.addEventListener("abort", () => failed(given.reason));
    });
  const search = new VariantSearch({ document, tell: (text) => told.push(text), found: (one) => found.push(one) },
    { studio: { findVariants } } as unknown as Clients);
  const ended = search.start();
  return { document, told, found, search, ended, answer: (count: number) =>
    answer({ document: create(DocumentSchema, { id: "d", revision: 4n, layoutId: "a", variantCount: count }) }) };
}

test("what was found is the document's", async () => {
  const { found, told, search, ended, answer } = begun();
  assert.notEqual(search.began.value, undefined);
  answer(2);
  await ended;
  assert.deepEqual([found.length, told.length, search.began.value], [1, 0, undefined]);
});

test("that nothing was found is told", async () => {
  const { told, ended, answer } = begun();
  answer(0);
  await ended;
  assert.match(told[0]!, /no other layout/);
});

test("who cancels is told nothing, who changes the room why it ended", async () => {
  const cancelled = begun();
  cancelled.search.cancel();
  await cancelled.ended;
  assert.deepEqual([cancelled.told, cancelled.found], [[], []]);
  const changed = begun();
  changed.document.value = create(DocumentSchema, { id: "d", revision: 4n, layoutId: "b" });
  await changed.ended;
  assert.match(changed.told[0]!, /changed meanwhile/);
  assert.equal(changed.search.began.value, undefined);
});
