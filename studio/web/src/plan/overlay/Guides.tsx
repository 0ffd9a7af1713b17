// SPDX-License-Identifier: GPL-3.0-or-later
import { usePlan } from "../context";
import { toScreen } from "../view";

// Lines that what is dragged has caught.
export function Guides() {
  const plan = usePlan(), view = plan.view.value;
  return (
    <g pointer-events="none">
      {plan.guides.value.map((guide, i) => {
        const a = toScreen(view, guide.a), b = toScreen(view, guide.b);
        return <line key={i} class={`guide is-${guide.kind}`} x1={a.x} y1={a.y} x2={b.x} y2={b.y} />;
      })}
    </g>
  );
}
