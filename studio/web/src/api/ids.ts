// SPDX-License-Identifier: GPL-3.0-or-later
// A request id that nobody has used.
export function newRequestId(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(12));
  return `page-${[...bytes].map((byte) => byte.toString(16).padStart(2, "0")).join("")}`;
}
