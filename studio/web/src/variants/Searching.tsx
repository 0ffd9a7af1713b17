// SPDX-License-Identifier: GPL-3.0-or-later
// The button that searches for other layouts, and what there is to see while it does.
import { useEffect, useState } from "preact/hooks";
import type { OpenRoom } from "../state/open_room";

export function OtherLayouts({ room, label = "Other layouts" }: { room: OpenRoom; label?: string }) {
  const isEmpty = room.pieces.value.size === 0;
  const isSearching = room.search.began.value !== undefined;
  return (
    <button
      class="button"
      disabled={isEmpty || isSearching || room.isBusy.value}
      title={isEmpty
        ? "Nothing stands in the room yet"
        : "Search for other ways to place the same pieces; what is locked stays (O)"}
      onClick={() => void room.search.start()}
    >
      {label}
    </button>
  );
}

export function Searching({ room, began }: { room: OpenRoom; began: number }) {
  const [now, setNow] = useState(Date.now());
  useEffect(() => {
    const timer = setInterval(() => setNow(Date.now()), 500);
    return () => clearInterval(timer);
  }, []);
  const seconds = Math.max(0, Math.floor((now - began) / 1000));
  return (
    <p class="searching" role="status">
      <span class="spinner" />
      <span>Searching for other layouts...</span>
      <span class="hint" aria-hidden="true">{seconds > 0 && `${seconds} s`}</span>
      <button class="button" onClick={() => room.search.cancel()}>Cancel</button>
    </p>
  );
}
