// SPDX-License-Identifier: GPL-3.0-or-later
// The one stream of a page: what happens to documents, with retries for as long as the page is open.
import type { Clients } from "./clients";
import { isRefused } from "./problems";
import type { WatchDocumentsResponse } from "../gen/flair/v1/studio_service_pb";

// "refused": the server is another one by now and does not know this page's key.
export type Connection = "connecting" | "online" | "away" | "refused";

export interface Watcher {
  // Called after every (re)connection: whatever happened before is not told.
  connected(): Promise<void>;
  heard(event: WatchDocumentsResponse["event"]): void;
  state(connection: Connection): void;
}

const kFirstPause = 1;
const kLongestPause = 15;

function pause(seconds: number, signal: AbortSignal): Promise<void> {
  return new Promise((done) => {
    const timer = setTimeout(done, seconds * 1000);
    signal.addEventListener("abort", () => { clearTimeout(timer); done(); }, { once: true });
    addEventListener("online", () => { clearTimeout(timer); done(); }, { once: true });
  });
}

export async function watchDocuments(clients: Clients, watcher: Watcher, signal: AbortSignal): Promise<void> {
  let seconds = kFirstPause;
  while (!signal.aborted) {
    try {
      const events = clients.studio.watchDocuments({}, { signal })[Symbol.asyncIterator]();
      let next = events.next();
      // It is looked at only once the documents are there; until then nobody else would take its failure.
      next.catch(() => {});
      await watcher.connected();
      watcher.state("online");
      seconds = kFirstPause;
      for (let { done, value } = await next; !done; { done, value } = await (next = events.next())) {
        watcher.heard(value.event);
      }
      watcher.state("away");
    } catch (error) {
      if (signal.aborted) return;
      watcher.state(isRefused(error) ? "refused" : "away");
    }
    await pause(seconds, signal);
    seconds = Math.min(seconds * 2, kLongestPause);
  }
}
