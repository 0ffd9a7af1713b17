// SPDX-License-Identifier: GPL-3.0-or-later
// A layout in the renderer's own parts, small and still.
import { memo } from "preact/compat";
import type { Placement } from "../gen/flair/v1/placement_pb";
import type { PlanParts } from "../gen/flair/v1/renderer_service_pb";
import type { SolvedLayout } from "../gen/flair/v1/solved_layout_pb";
import { boxOf } from "../geometry/polygon";
import { Drawn } from "../plan/Drawn";
import { plainFloor, plainSymbol } from "../plan/plain";
import { floorOf } from "../state/pieces";

interface Props {
  layout: SolvedLayout;
  placements: readonly Placement[];
  parts: PlanParts | undefined;
}

const kMargin = 0.3;

export const SmallPlan = memo(
  function SmallPlan({ layout, placements, parts }: Props) {
    const floor = floorOf(layout),
      { min, max } = boxOf(floor);
    const at = new Map(placements.map((one) => [one.objectId, one]));
    const objects = new Map(layout.graph?.objectList?.objects.map((one) => [one.id, one]));
    const plain = plainFloor(floor);
    const known = new Map(parts?.parts.map((part) => [part.objectId, part]));
    const order = [...placements].sort((a, b) => a.zM - b.zM).map(({ objectId }) => objectId);
    const drawn = parts ? parts.parts.map((part) => part.objectId).filter((id) => at.has(id)) : order;
    const piece = (id: string) => {
      const { xM, yM, thetaRad } = at.get(id)!;
      const object = objects.get(id);
      const svg = known.get(id)?.svg ?? (object ? plainSymbol({ width: object.widthM, depth: object.depthM }, object.round) : "");
      return (
        <g key={id} transform={`translate(${xM} ${-yM}) rotate(${(-thetaRad * 180) / Math.PI})`}>
          <Drawn svg={svg} />
        </g>
      );
    };
    return (
      <svg
        class="small-plan"
        viewBox={`${min.x - kMargin} ${-max.y - kMargin} ${max.x - min.x + 2 * kMargin} ${max.y - min.y + 2 * kMargin}`}
        aria-hidden="true"
      >
        <Drawn svg={parts?.floorSvg || plain.floor} />
        {drawn.filter((id) => known.get(id)?.belowFurniture).map(piece)}
        {drawn.filter((id) => !known.get(id)?.belowFurniture && !known.get(id)?.aboveWalls).map(piece)}
        <Drawn svg={parts?.wallsSvg || plain.walls} />
        {drawn.filter((id) => known.get(id)?.aboveWalls).map(piece)}
      </svg>
    );
  },
  (a, b) => a.layout === b.layout && a.placements === b.placements && a.parts === b.parts,
);
