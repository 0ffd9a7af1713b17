// SPDX-License-Identifier: GPL-3.0-or-later
import { figure } from "../../app/units";
import { sizeShifts } from "../../geometry/dimensions";
import { edgesOf } from "../../geometry/polygon";
import { add, distance, left, middle, sub, times, unit, vec } from "../../geometry/vec";
import { usePlan } from "../context";
import { toScreen } from "../view";

const kWall = 0.15;
const kGap = 18;
const kTick = 4;

// To be read from below or from the right, as on drawings.
function angleOf(along: { x: number; y: number }): number {
  const degrees = (Math.atan2(along.y, along.x) * 180) / Math.PI;
  return degrees > 89.9 || degrees < -90.1 ? degrees + 180 : degrees;
}

// How long the walls are, outside of them, as on the sheet.
export function WallSizes() {
  const plan = usePlan(), view = plan.view.value, units = plan.studio.settings.units.value;
  const floor = plan.room.floor.value, edges = edgesOf(floor), outward = sizeShifts(floor);
  return (
    <g class="wall-sizes" pointer-events="none">
      {edges.map(({ a, b, inward }, i) => {
        const metres = distance(a, b);
        if (metres * view.scale < 34) return null;
        const out = vec(-inward.x, inward.y);
        const shift = times(out, (kWall + outward[i]!) * view.scale + kGap);
        const from = add(toScreen(view, a), shift), to = add(toScreen(view, b), shift), at = middle(from, to);
        const tick = times(left(unit(sub(to, from))), kTick);
        return (
          <g key={i}>
            <line x1={from.x} y1={from.y} x2={to.x} y2={to.y} />
            {[from, to].map((end, j) => (
              <line key={j} x1={end.x - tick.x} y1={end.y - tick.y} x2={end.x + tick.x} y2={end.y + tick.y} />
            ))}
            <text transform={`translate(${at.x} ${at.y}) rotate(${angleOf(sub(to, from))})`} y="4">
              {figure(metres, units)}
            </text>
          </g>
        );
      })}
    </g>
  );
}
