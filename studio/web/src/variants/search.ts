// SPDX-License-Identifier: GPL-3.0-or-later
// The search for other layouts of what is shown. It takes seconds; whoever changes the room meanwhile ends it, for what it
// would find would not be of what is shown any more.
import { signal } from "@preact/signals";
import { isCancelled, isConflict, sentenceOf } from "../api/problems";
import type { Clients } from "../api/clients";
import type { Document } from "../gen/flair/v1/studio_service_pb";

const kCount = 4;
const kChanged = "changed";

// What it needs of an open room.
export interface Searched {
  readonly document: { peek(): Document; subscribe(told: (document: Document) => void): () => void };
  tell(text: string): void;
  // The document with what was found.
  found(document: Document): void;
}

export class VariantSearch {
  // When it began, as Date.now(); undefined while there is none.
  readonly began = signal<number | undefined>(undefined);
  private abort: AbortController | undefined;

  constructor(private readonly room: Searched, private readonly clients: Clients) {}

  async start(): Promise<void> {
    if (this.began.peek() !== undefined) return;
    const { id: documentId, revision, layoutId } = this.room.document.peek();
    const abort = (this.abort = new AbortController());
    this.began.value = Date.now();
    const end = this.room.document.subscribe((document) => {
      if (document.layoutId !== layoutId) abort.abort(kChanged);
    });
    try {
      // Another revision, another seed: searching again finds others.
      const request = { documentId, revision, count: kCount, seed: revision };
      const { document } = await this.clients.studio.findVariants(request, { signal: abort.signal });
      if (abort.signal.aborted || !document) return;
      this.room.found(document);
      if (document.variantCount === 0)
        this.room.tell("There is no other layout: what is locked and wished for leaves just this one.");
    } catch (error) {
      const isChanged = abort.signal.reason === kChanged || (!abort.signal.aborted && isConflict(error));
      if (isChanged) this.room.tell("The room was changed meanwhile. Search again for layouts of what it is now.");
      else if (!abort.signal.aborted && !isCancelled(error)) this.room.tell(sentenceOf(error));
    } finally {
      end();
      this.began.value = undefined;
    }
  }

  cancel(): void {
    this.abort?.abort();
  }
}
