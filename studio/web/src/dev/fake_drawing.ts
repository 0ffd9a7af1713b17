// SPDX-License-Identifier: GPL-3.0-or-later
// Plain rectangles in the place of the renderer's drawing.
import { create } from "@bufbuild/protobuf";
import { ObjectKind, type Object$ } from "../gen/flair/v1/object_list_pb";
import { PlanPartSchema, PlanPartsSchema, type PlanParts } from "../gen/flair/v1/renderer_service_pb";
import type { SolvedLayout } from "../gen/flair/v1/solved_layout_pb";
import { edgesOf } from "../geometry/polygon";
import { add, times, type Vec } from "../geometry/vec";
import { floorOf } from "../state/pieces";

const points = (list: readonly Vec[]) => list.map((p) => `${p.x},${-p.y}`).join(" ");

export function symbol({ widthM: w, depthM: d, round, kind, walkOver }: Object$): string {
  const fill = walkOver ? "#efece4" : kind === ObjectKind.SURFACE ? "#d8dde2" : "#e8ceb2";
  const dash = kind === ObjectKind.CEILING ? ' stroke-dasharray="0.06 0.04" fill-opacity="0"' : "";
  if (round) return `<circle r="${w / 2}" fill="${fill}" stroke="#33302c" stroke-width="0.01"${dash}/>`;
  return (
    `<g><rect x="${-w / 2}" y="${-d / 2}" width="${w}" height="${d}" rx="0.02" fill="${fill}" stroke="#33302c" ` +
    `stroke-width="0.012"${dash}/><path d="M${-w / 2} ${d / 2 - d * 0.12}H${w / 2}" stroke="#8d7a66" stroke-width="0.008"/></g>`
  );
}

export function drawing(layout: SolvedLayout): PlanParts {
  const floor = floorOf(layout);
  const walls = edgesOf(floor).map(({ a, b, inward }) => {
    const out = times(inward, -0.14),
      along = times({ x: inward.y, y: -inward.x }, 0.14);
    const corners = [
      add(a, times(along, -1)),
      add(b, along),
      add(add(b, along), out),
      add(add(a, times(along, -1)), out),
    ];
    return `<polygon points="${points(corners)}" fill="#575349"/>`;
  });
  const placed = new Set(layout.placements.map((one) => one.objectId));
  const parts = (layout.graph?.objectList?.objects ?? [])
    .filter((one) => placed.has(one.id))
    .map((object) =>
      create(PlanPartSchema, {
        objectId: object.id,
        svg: symbol(object),
        label: object.kind === ObjectKind.FLOOR && !object.walkOver ? object.name : "",
        labelSizeM: 0.1,
        aboveWalls: object.kind === ObjectKind.CEILING || object.kind === ObjectKind.WALL,
        belowFurniture: object.walkOver,
      }),
    );
  return create(PlanPartsSchema, {
    floorSvg: `<polygon points="${points(floor)}" fill="#f9e7d4"/>`, wallsSvg: `<g>${walls.join("")}</g>`, parts,
  });
}
