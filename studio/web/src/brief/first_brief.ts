// SPDX-License-Identifier: GPL-3.0-or-later
import { signal } from "@preact/signals";

// What the start page's field begins with, once.
export const firstBrief = signal("");
