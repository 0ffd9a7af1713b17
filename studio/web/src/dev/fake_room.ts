// SPDX-License-Identifier: GPL-3.0-or-later
// One document of the fake server with its history.
import { clone, create, fromJson, type JsonObject, type JsonValue } from "@bufbuild/protobuf";
import { timestampNow } from "@bufbuild/protobuf/wkt";
import { LayoutGraphSchema } from "../gen/flair/v1/layout_graph_pb";
import { ObjectListSchema } from "../gen/flair/v1/object_list_pb";
import { OutcomeStatus, SolvedLayoutSchema, type SolvedLayout } from "../gen/flair/v1/solved_layout_pb";
import { DocumentSchema, type Document } from "../gen/flair/v1/studio_service_pb";
import type { Room } from "../gen/flair/v1/room_pb";
import bedroom from "./data/bedroom.json";
import { judge } from "./fake_judge";

interface Entry {
  readonly label: string;
  readonly layout: SolvedLayout;
}

export const bedroomLayout = (): SolvedLayout =>
  fromJson(SolvedLayoutSchema, bedroom.layout as unknown as JsonValue);

export function emptyLayout(room: Room): SolvedLayout {
  const graph = create(LayoutGraphSchema, { room, objectList: create(ObjectListSchema) });
  return create(SolvedLayoutSchema, { graph });
}

// The fake solves nothing but when it settles.
const kUnsettling = /^(?!settle|design|$)/;

let documentCount = 0;

export class FakeRoom {
  readonly document: Document;
  // What the last move moved.
  moved: ReadonlySet<string> = new Set();
  private entries: Entry[] = [];
  private at = -1;

  constructor(title: string, layout?: SolvedLayout) {
    const now = timestampNow();
    documentCount += 1;
    this.document = create(DocumentSchema, {
      id: `d${String(documentCount).padStart(4, "0")}`, revision: 1n, title, createTime: now, updateTime: now,
    });
    if (layout) this.put("design the room", layout);
  }

  get layout(): SolvedLayout | undefined {
    return this.entries[this.at]?.layout;
  }

  copy(): SolvedLayout {
    return clone(SolvedLayoutSchema, this.layout ?? create(SolvedLayoutSchema));
  }

  put(label: string, layout: SolvedLayout): void {
    const outcomes = new Map(layout.edgeOutcomes.map((one) => [one.edgeId, one]));
    const { edgeOutcomes, findings } = judge(layout, layout.placements.map((one) => one.objectId));
    for (const one of edgeOutcomes) outcomes.set(one.edgeId, one);
    layout.edgeOutcomes = [...outcomes.values()];
    if (layout.metrics) layout.metrics.findings = findings;
    this.entries = [...this.entries.slice(0, this.at + 1), { label, layout }];
    this.step(this.entries.length - 1);
  }

  undo(by: -1 | 1): boolean {
    if (by < 0 ? this.at < 1 : this.at + 1 >= this.entries.length) return false;
    this.step(this.at + by);
    return true;
  }

  touch(): void {
    this.document.revision += 1n;
    this.document.updateTime = timestampNow();
  }

  // As explain writes it, with the verdicts as they now are.
  note(): JsonObject {
    const note = structuredClone(bedroom.note) as unknown as JsonObject;
    if (this.layout?.graph?.room?.roomType !== "bedroom" || this.layout.placements.length === 0) return {};
    const outcomes = new Map(this.layout.edgeOutcomes.map((one) => [one.edgeId, one]));
    for (const zone of note.zones as JsonObject[]) {
      for (const object of (zone.objects ?? []) as JsonObject[]) {
        for (const demand of (object.demands ?? []) as JsonObject[]) {
          const edge = outcomes.get(((demand.edge_ids ?? []) as string[])[0] ?? "");
          if (edge?.status !== OutcomeStatus.VIOLATED) continue;
          demand.fate = "missed";
          demand.shortfall = edge.reason;
        }
      }
    }
    return note;
  }

  private step(to: number): void {
    this.at = to;
    this.document.layoutId = `layout-${this.document.id}-${to}`;
    this.document.undoLabel = to > 0 ? this.entries[to]!.label : "";
    this.document.unsettled = kUnsettling.test(this.document.undoLabel);
    this.document.redoLabel = this.entries[to + 1]?.label ?? "";
    this.touch();
  }
}
