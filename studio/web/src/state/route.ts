// SPDX-License-Identifier: GPL-3.0-or-later
// Which page is shown, from the address behind "#", so that a reload shows it again.
import { signal } from "@preact/signals";

export type Page = "start" | "document" | "draw" | "jobs";

export interface Route {
  readonly page: Page;
  // Of the document; empty on other pages.
  readonly id: string;
}

export function parseRoute(hash: string): Route {
  const [page, id = ""] = hash.replace(/^#\/?/, "").split("/");
  if (page === "room" && id) return { page: "document", id: decodeURIComponent(id) };
  if (page === "draw") return { page, id: decodeURIComponent(id) };
  if (page === "jobs") return { page, id: decodeURIComponent(id) };
  return { page: "start", id: "" };
}

export function hashOf({ page, id = "" }: { page: Page; id?: string }): string {
  const words = { start: "", document: "room", draw: "draw", jobs: "jobs" }[page];
  return `#/${[words, encodeURIComponent(id)].filter(Boolean).join("/")}`;
}

export const route = signal<Route>(parseRoute(globalThis.location?.hash ?? ""));

export function goTo(to: { page: Page; id?: string }): void {
  location.hash = hashOf(to);
}

globalThis.addEventListener?.("hashchange", () => { route.value = parseRoute(location.hash); });
