// SPDX-License-Identifier: GPL-3.0-or-later
import type { ConstraintEdge } from "../../gen/flair/v1/layout_graph_pb";
import type { EdgeOutcome } from "../../gen/flair/v1/solved_layout_pb";
import type { OpenRoom } from "../../state/open_room";

// The constraints that are drawn: those of the sentence that is pointed at, else those of the piece that is dragged.
export function shownEdges(room: OpenRoom): Array<{ edge: ConstraintEdge; outcome: EdgeOutcome | undefined }> {
  const verdict = room.judging.verdict.value, demand = room.pointedAt.value;
  if (!verdict && !demand) return [];
  const outcomes = demand ? room.outcomes.value : verdict!.outcomes;
  const wanted = new Set(demand ? demand.edge_ids : outcomes.keys());
  return (room.layout.value?.graph?.edges ?? []).filter((edge) => wanted.has(edge.id))
    .map((edge) => ({ edge, outcome: outcomes.get(edge.id) }));
}
