// SPDX-License-Identifier: GPL-3.0-or-later
import { timestampDate, type Timestamp } from "@bufbuild/protobuf/wkt";

// "just now", "5 min ago", "14:30", "Tue 14:30", "3 Mar".
export function whenText(time: Timestamp | undefined, now: Date): string {
  if (!time) return "";
  const date = timestampDate(time);
  const minutes = (now.getTime() - date.getTime()) / 60_000;
  if (minutes < 1) return "just now";
  if (minutes < 60) return `${Math.floor(minutes)} min ago`;
  const clock = date.toLocaleTimeString([], { hour: "2-digit", minute: "2-digit" });
  if (date.toDateString() === now.toDateString()) return clock;
  if (minutes < 6 * 24 * 60) return `${date.toLocaleDateString([], { weekday: "short" })} ${clock}`;
  return date.toLocaleDateString([], { day: "numeric", month: "short" });
}
