// SPDX-License-Identifier: GPL-3.0-or-later
import { figure } from "../../app/units";
import { distance, middle } from "../../geometry/vec";
import { OutcomeStatus } from "../../gen/flair/v1/solved_layout_pb";
import { usePlan } from "../context";
import { linksOf, type Link } from "../operands";
import { toScreen } from "../view";
import { shownEdges } from "./shown_edges";

interface Line extends Link {
  readonly isMissed: boolean;
}

// Constraints as lines to what they are about: those of the piece in hand, in the colour of their verdict while it is
// dragged, and those of the sentence that is pointed at with their distances.
export function Lines() {
  const plan = usePlan(), { room } = plan;
  const layoutRoom = room.layout.value?.graph?.room, demand = room.pointedAt.value;
  const byTarget = new Map<string, Line>();
  for (const { edge, outcome } of layoutRoom ? shownEdges(room) : []) {
    const isMissed = outcome?.status === OutcomeStatus.VIOLATED;
    for (const link of linksOf(edge, layoutRoom!, room.pieces.value, (id) => room.poseOf(id))) {
      const key = demand ? `${edge.id} ${link.target}` : link.target;
      if (!byTarget.has(key) || isMissed) byTarget.set(key, { ...link, isMissed });
    }
  }
  const view = plan.view.value, units = plan.studio.settings.units.value;
  return (
    <g class="links" pointer-events="none">
      {[...byTarget].map(([key, line]) => {
        const a = toScreen(view, line.from), b = toScreen(view, line.to), at = middle(a, b);
        const metres = distance(line.from, line.to);
        return (
          <g key={key} class={line.isMissed ? "link is-missed" : "link"}>
            <line x1={a.x} y1={a.y} x2={b.x} y2={b.y} />
            <circle cx={a.x} cy={a.y} r={2.5} />
            <circle cx={b.x} cy={b.y} r={2.5} />
            {demand && metres * view.scale > 14 && <text x={at.x} y={at.y - 5}>{figure(metres, units)}</text>}
          </g>
        );
      })}
    </g>
  );
}
