// SPDX-License-Identifier: GPL-3.0-or-later
// Brings several pieces into line with each other, or to equal distances.
import { Icon, type IconName } from "../app/Icon";
import { aligned, spread, type Axis, type Line } from "../geometry/align";
import { moved } from "../geometry/footprint";
import { boxOf, type Box } from "../geometry/polygon";
import type { Vec } from "../geometry/vec";
import { standAt, tellLocked } from "../state/commands";
import type { OpenRoom } from "../state/open_room";
import { footprintOf, type Piece } from "../state/pieces";

const line = (axis: Axis, at: Line) => (boxes: readonly Box[]): Vec[] => aligned(boxes, axis, at);

const acts: ReadonlyArray<{ name: string; icon: IconName; least: number; by(boxes: readonly Box[]): Vec[] }> = [
  { name: "Align the western sides", icon: "alignWest", least: 2, by: line("x", "min") },
  { name: "Align the middles, from west to east", icon: "alignAcross", least: 2, by: line("x", "middle") },
  { name: "Align the eastern sides", icon: "alignEast", least: 2, by: line("x", "max") },
  { name: "Align the northern sides", icon: "alignNorth", least: 2, by: line("y", "max") },
  { name: "Align the middles, from south to north", icon: "alignAlong", least: 2, by: line("y", "middle") },
  { name: "Align the southern sides", icon: "alignSouth", least: 2, by: line("y", "min") },
  { name: "Equal gaps from west to east", icon: "spreadAcross", least: 3, by: (boxes) => spread(boxes, "x") },
  { name: "Equal gaps from south to north", icon: "spreadAlong", least: 3, by: (boxes) => spread(boxes, "y") },
];

export function AlignActs({ room, pieces }: { room: OpenRoom; pieces: readonly Piece[] }) {
  const run = (by: (boxes: readonly Box[]) => Vec[]) => {
    // Where a locked one would have to go, nothing goes.
    if (pieces.some(({ pinned }) => pinned)) return tellLocked(room, pieces);
    const shifts = by(pieces.map((piece) => boxOf(footprintOf(piece))));
    void standAt(room, new Map(pieces.map(({ id, pose }, i) => [id, moved(pose, shifts[i]!)])));
  };
  return (
    <div class="button-group align-acts" role="group" aria-label="Align">
      {acts.map(({ name, icon, least, by }) => (
        <button key={icon} class="icon-button" aria-label={name} title={name} disabled={pieces.length < least}
          onClick={() => run(by)}>
          <Icon name={icon} />
        </button>
      ))}
    </div>
  );
}
