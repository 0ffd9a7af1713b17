// SPDX-License-Identifier: GPL-3.0-or-later
// Zoom buttons and the scale bar in the plan's corner.
import { useEffect, useRef } from "preact/hooks";
import { Icon } from "../app/Icon";
import { vec } from "../geometry/vec";
import { usePlan } from "./context";
import { zoomedAt } from "./view";

const kSteps = { m: [0.1, 0.25, 0.5, 1, 2, 5, 10], ft: [0.3048, 0.6096, 1.524, 3.048, 6.096, 15.24] };
const kWidest = 130;

function ScaleBar() {
  const plan = usePlan();
  const units = plan.studio.settings.units.value, scale = plan.view.value.scale;
  const metres = [...kSteps[units]].reverse().find((step) => step * scale <= kWidest) ?? kSteps[units][0]!;
  const bar = useRef<HTMLDivElement>(null);
  useEffect(() => { bar.current!.style.width = `${metres * scale}px`; }, [metres, scale]);
  const text = units === "m" ? `${metres} m` : `${Math.round(metres / 0.3048)} ft`;
  return (
    <div class="scale-bar" aria-label={`Scale: this bar is ${text} long`}>
      <div ref={bar} />
      <span>{text}</span>
    </div>
  );
}

export function PlanTools() {
  const plan = usePlan();
  const zoom = (factor: number) =>
    plan.setView(zoomedAt(plan.view.peek(), vec(plan.width.peek() / 2, plan.height.peek() / 2), factor));
  return (
    <div class="plan-tools">
      <ScaleBar />
      <div class="button-group">
        <button class="icon-button" aria-label="Zoom out" title="Zoom out (-)" onClick={() => zoom(1 / 1.25)}>
          <Icon name="minus" />
        </button>
        <button class="icon-button" aria-label="Zoom in" title="Zoom in (+)" onClick={() => zoom(1.25)}>
          <Icon name="plus" />
        </button>
        <button class="icon-button" aria-label="Fit the room" title="Fit the room (0)" onClick={() => plan.fit()}>
          <Icon name="fit" />
        </button>
      </div>
    </div>
  );
}
