// SPDX-License-Identifier: GPL-3.0-or-later
import { figure } from "../../app/units";
import { add, distance, left, middle, sub, times, unit, vec, type Vec } from "../../geometry/vec";
import { theName } from "../../state/pieces";
import { usePlan } from "../context";
import { shownClearances } from "../clearance_of";
import { editedClearance } from "../ClearanceField";
import { resizing } from "../gestures/resize";
import { toScreen } from "../view";

const kTick = 4;
// Less is none; a shorter line has its figure beside it, clear of the handles.
const kTouch = 0.004;
const kShort = 44;
const kAside = 26;

// From the end of a dimension to what is met, where that is aside.
function Witness({ from, to }: { from: Vec; to: Vec }) {
  if (distance(from, to) < kTick) return null;
  const beyond = add(to, times(unit(sub(to, from)), kTick));
  return <line class="witness" x1={from.x} y1={from.y} x2={beyond.x} y2={beyond.y} />;
}

// Dimension lines from the piece in hand to what is next to it. Their figures can be clicked and typed.
export function Clearances() {
  const plan = usePlan();
  const shown = resizing.value ? undefined : shownClearances(plan);
  if (!shown) return null;
  const view = plan.view.value, units = plan.studio.settings.units.value;
  const isIdle = !plan.gesture.value;
  return (
    <g class="clearances">
      {shown.list.filter((one) => one.metres > kTouch).map((one) => {
        const a = toScreen(view, one.from), b = toScreen(view, one.to);
        const aside = distance(a, b) < kShort ? times(left(unit(sub(b, a))), kAside) : vec(0, 0);
        const at = add(middle(a, b), aside);
        const tick = times(left(unit(sub(b, a))), kTick);
        const text = figure(one.metres, units);
        const width = text.length * 6.6 + 10;
        const ends = [a, b].map((end) => ({ p: add(end, tick), q: sub(end, tick) }));
        const edit = () => {
          if (isIdle && !shown.piece.pinned) editedClearance.value = { pieceId: shown.piece.id, side: one.side };
        };
        return (
          <g key={one.side} class="clearance">
            <line x1={a.x} y1={a.y} x2={b.x} y2={b.y} />
            <Witness from={b} to={toScreen(view, one.met)} />
            {ends.map(({ p, q }, i) => <line key={i} x1={p.x} y1={p.y} x2={q.x} y2={q.y} />)}
            <g data-field="" role="button"
              aria-label={`${one.side} clearance of ${theName(shown.piece.object)}: ${text}`}
              class="figure" transform={`translate(${at.x} ${at.y})`} onClick={edit}>
              <rect x={-width / 2} y={-9} width={width} height={18} rx={4} />
              <text y={4}>{text}</text>
            </g>
          </g>
        );
      })}
    </g>
  );
}
