// SPDX-License-Identifier: GPL-3.0-or-later
// What the fake server does on an act: enough to see the page work, no more.
import { create } from "@bufbuild/protobuf";
import { Code, ConnectError } from "@connectrpc/connect";
import { DiagnosticSchema, Severity, type Diagnostic } from "../gen/flair/v1/provenance_pb";
import { PlacementSchema, type Placement } from "../gen/flair/v1/placement_pb";
import { ObjectKind } from "../gen/flair/v1/object_list_pb";
import type { EditLayout, ActRequest } from "../gen/flair/v1/studio_service_pb";
import type { SolvedLayout } from "../gen/flair/v1/solved_layout_pb";
import { guestsOf, nameOf, piecesOf } from "../state/pieces";
import { toObject, toRoom } from "../geometry/footprint";
import { vec } from "../geometry/vec";
import { bedroomLayout, type FakeRoom } from "./fake_room";

// Puts objects there, and what stands on them beside.
function move(layout: SolvedLayout, placements: readonly Placement[]): void {
  const pieces = piecesOf(layout);
  const named = new Map(placements.map((one) => [one.objectId, one]));
  for (const { objectId, xM, yM, thetaRad } of placements) {
    const host = pieces.get(objectId);
    if (!host) throw new ConnectError(`act.move: no object is called "${objectId}"`, Code.InvalidArgument);
    for (const id of guestsOf(pieces, [objectId])) {
      const guest = layout.placements.find((one) => one.objectId === id)!;
      if (named.has(id)) continue;
      const at = toRoom({ x: xM, y: yM, theta: thetaRad }, toObject(host.pose, vec(guest.xM, guest.yM)));
      Object.assign(guest, { xM: at.x, yM: at.y, thetaRad: guest.thetaRad + thetaRad - host.pose.theta });
    }
    Object.assign(layout.placements.find((one) => one.objectId === objectId)!, { xM, yM, thetaRad });
  }
}

function edit(layout: SolvedLayout, { edits }: EditLayout): string {
  let label = "edit";
  const graph = layout.graph!;
  for (const { edit: one } of edits) {
    if (one.case === "moveObject") move(layout, [one.value]);
    if (one.case === "pinObjectId") {
      graph.pinnedPlacements.push(layout.placements.find((at) => at.objectId === one.value)!);
      label = `lock the ${one.value}`;
    }
    if (one.case === "unpinObjectId") {
      graph.pinnedPlacements = graph.pinnedPlacements.filter((at) => at.objectId !== one.value);
      label = `unlock the ${one.value}`;
    }
    if (one.case === "resizeObject") {
      const object = graph.objectList!.objects.find((each) => each.id === one.value.objectId)!;
      object.widthM = one.value.widthM ?? object.widthM;
      object.depthM = one.value.depthM ?? object.depthM;
      object.heightM = one.value.heightM ?? object.heightM;
      label = `resize the ${nameOf(object)}`;
    }
    if (one.case === "removeObjectId") {
      graph.objectList!.objects = graph.objectList!.objects.filter((each) => each.id !== one.value);
      layout.placements = layout.placements.filter((each) => each.objectId !== one.value);
      label = "remove";
    }
    if (one.case === "addObject" && one.value.object) {
      graph.objectList!.objects.push(one.value.object);
      const room = graph.room!.floor!.vertices;
      const middle = (pick: (v: { xM: number; yM: number }) => number) =>
        (Math.min(...room.map(pick)) + Math.max(...room.map(pick))) / 2;
      layout.placements.push(create(PlacementSchema,
        { objectId: one.value.object.id, xM: middle((v) => v.xM), yM: middle((v) => v.yM) }));
      label = `add the ${nameOf(one.value.object)}`;
    }
  }
  return label;
}

// Everything but what was moved last goes back to where the design had it.
function settle(layout: SolvedLayout, keep: ReadonlySet<string>): void {
  const first = new Map(bedroomLayout().placements.map((one) => [one.objectId, one]));
  for (const at of layout.placements) {
    const back = first.get(at.objectId);
    if (back && !keep.has(at.objectId)) Object.assign(at, { xM: back.xM, yM: back.yM, thetaRad: back.thetaRad });
  }
}

export function act(room: FakeRoom, { act: asked }: ActRequest): Diagnostic[] {
  const layout = room.copy();
  switch (asked.case) {
    case "move": {
      move(layout, asked.value.placements);
      room.moved = new Set(asked.value.placements.map((one) => one.objectId));
      room.put(`move the ${asked.value.placements[0]?.objectId.replace(/_/g, " ")}`, layout);
      return [];
    }
    case "edit": room.put(edit(layout, asked.value), layout); return [];
    case "settle": settle(layout, room.moved); room.put("settle", layout); return [];
    case "undo": case "redo":
      if (!room.undo(asked.case === "undo" ? -1 : 1)) {
        throw new ConnectError(`There is nothing to ${asked.case}.`, Code.FailedPrecondition);
      }
      return [];
    case "title":
      room.document.title = asked.value;
      room.touch();
      return [];
    case "say":
      return [
        create(DiagnosticSchema, {
          severity: Severity.WARNING,
          code: "unknown_sentence",
          message: `"${asked.value.text}" is not understood: say which piece faces what`,
        }),
      ];
    case "weigh":
      room.put("weigh a sentence", layout);
      return [];
    case "replace": {
      const object = layout.graph!.objectList!.objects.find((one) => one.id === asked.value.objectId)!;
      const { name, widthM, depthM, heightM, category } = asked.value.by!;
      Object.assign(object, { name, widthM, depthM, heightM, category, kind: ObjectKind.FLOOR });
      room.put(`replace the ${object.name}`, layout);
      return [];
    }
    default: throw new ConnectError("The fake server does not know how.", Code.Unimplemented);
  }
}
