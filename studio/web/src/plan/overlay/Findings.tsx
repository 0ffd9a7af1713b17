// SPDX-License-Identifier: GPL-3.0-or-later
import { useComputed } from "@preact/signals";
import { memo } from "preact/compat";
import { clipped } from "../../geometry/polygon";
import { FindingKind, type Finding } from "../../gen/flair/v1/layout_metrics_pb";
import { footprintOf } from "../../state/pieces";
import { findingsOf } from "../../state/faults";
import { doorSweep } from "../doors";
import { usePlan } from "../context";
import { pixelPoints } from "./pixels";

const kShown = new Set([FindingKind.OVERLAP, FindingKind.DOOR_LEAF, FindingKind.OUTSIDE, FindingKind.COVERS_OPENING]);

// One of them; its polygons follow the pieces without the list being drawn again.
const Mark = memo(function Mark({ finding }: { finding: Finding }) {
  const { room, view } = usePlan();
  const polygonOf = (id: string) => {
    const piece = room.pieces.value.get(id);
    return piece && footprintOf(piece, room.poseOf(id));
  };
  const shape = useComputed(() => {
    const own = polygonOf(finding.objectId), layoutRoom = room.layout.value?.graph?.room;
    if (!own) return { own: "", shared: "" };
    const partner = polygonOf(finding.partnerId) ?? (layoutRoom && doorSweep(layoutRoom, finding.partnerId));
    const shared = partner ? clipped(partner, own) : own;
    return {
      own: partner ? pixelPoints(view.value, own) : "",
      shared: shared.length > 2 ? pixelPoints(view.value, shared) : "",
    };
  });
  const own = useComputed(() => shape.value.own), shared = useComputed(() => shape.value.shared);
  return <g><polygon class="clash" points={own} /><polygon class="hatch" points={shared} /></g>;
});

// Red hatching where two things want the same place.
export function Findings() {
  const { room } = usePlan();
  return (
    <g class="findings" pointer-events="none">
      <defs>
        <pattern id="hatch" width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
          <rect width="7" height="7" class="hatch-ground" />
          <line x1="0" y1="0" x2="0" y2="7" class="hatch-line" />
        </pattern>
      </defs>
      {findingsOf(room)
        .filter((finding) => kShown.has(finding.kind))
        .map((finding, i) => (
          <Mark key={[finding.objectId, finding.partnerId, finding.kind, i].join(" ")} finding={finding} />
        ))}
    </g>
  );
}
