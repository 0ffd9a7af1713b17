// SPDX-License-Identifier: GPL-3.0-or-later
import { signal } from "@preact/signals";
import type { Object$ } from "../gen/flair/v1/object_list_pb";

// What is dragged from the drawer; browsers tell a drop's data only at its end.
export const carried = signal<Object$ | undefined>(undefined);
