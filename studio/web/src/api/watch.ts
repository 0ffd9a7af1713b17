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
      const stream = clients.studio.watchDocuments({}, { signal });
      await watcher.connected();
      watcher.state("online");
      seconds = kFirstPause;
      for await (const { event } of stream) watcher.heard(event);
      watcher.state("away");
    } catch (error) {
      if (signal.aborted) return;
      watcher.state(isRefused(error) ? "refused" : "away");
    }
    await pause(seconds, signal);
    seconds = Math.min(seconds * 2, kLongestPause);
  }
}
