// SPDX-License-Identifier: GPL-3.0-or-later
import { OutcomeStatus } from "../../gen/flair/v1/solved_layout_pb";
import { clearSpaceOf, stripBeside } from "../clear_space";
import { usePlan } from "../context";
import { pixelPoints } from "./pixels";
import { shownEdges } from "./shown_edges";

// Floor that is to be free, for the piece in hand and the sentence that is pointed at.
export function ClearSpaces() {
  const plan = usePlan(), { room } = plan, view = plan.view.value;
  const pieces = room.pieces.value;
  return (
    <g pointer-events="none">
      {shownEdges(room).map(({ edge, outcome }) => {
        const space = clearSpaceOf(edge);
        const piece = space && pieces.get(space.objectId), pose = space && room.poseOf(space.objectId);
        if (!space || !piece || !pose) return null;
        const isMissed = outcome?.status === OutcomeStatus.VIOLATED;
        return space.sides.map((side) => (
          <polygon key={`${edge.id} ${side}`} class={isMissed ? "clear-space is-missed" : "clear-space"}
            points={pixelPoints(view, stripBeside(pose, piece.size, side, space.metres))} />
        ));
      })}
    </g>
  );
}
