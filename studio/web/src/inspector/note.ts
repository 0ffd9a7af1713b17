// SPDX-License-Identifier: GPL-3.0-or-later
// What ExplainResponse.note holds; see docs/explain.md. Whatever is empty or false is left out.
import type { JsonObject } from "@bufbuild/protobuf";

export type Fate = "holds" | "missed" | "dropped" | "not understood";

export interface Demand {
  fate: Fate;
  about_it?: string;
  sentence_id?: string;
  sentence?: string;
  reason?: string;
  edge_ids?: string[];
  types?: string[];
  other_object_ids?: string[];
  shortfall?: string;
  // What stands in the way of one that is missed.
  because?: string;
  missed_by?: number;
  unit?: string;
}

export interface NoteObject {
  id: string;
  name: string;
  role?: string;
  placed?: boolean;
  zone_id?: string;
  requested?: boolean;
  pinned?: boolean;
  // What the user has done for it: "You put it there. You asked for a desk."
  origin?: string;
  stands?: string;
  demands?: Demand[];
  followers?: string[];
  remarks?: string[];
}

export interface NoteZone {
  id?: string;
  name?: string;
  purpose?: string;
  objects?: NoteObject[];
}

export interface NoteFinding {
  kind?: string;
  object_id?: string;
  partner_id?: string;
  amount?: number;
  unit?: string;
  message: string;
}

export interface Note {
  room?: string;
  demand_count?: { holds?: number; missed?: number; dropped?: number; not_understood?: number };
  uses?: { asked?: number; met?: number };
  findings?: NoteFinding[];
  zones?: NoteZone[];
  demands_of_no_object?: Demand[];
  left_out?: string[];
  clashes?: string[];
  remarks?: string[];
}

export const noteOf = (note: JsonObject | undefined): Note => (note ?? {}) as unknown as Note;

export function objectIn(note: Note | undefined, id: string): NoteObject | undefined {
  for (const zone of note?.zones ?? []) {
    const found = zone.objects?.find((object) => object.id === id);
    if (found) return found;
  }
  return undefined;
}
