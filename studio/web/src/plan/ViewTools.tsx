// SPDX-License-Identifier: GPL-3.0-or-later
// Zoom buttons and the scale bar in the corner of a drawing.
import { useEffect, useRef } from "preact/hooks";
import { Icon } from "../app/Icon";
import { useStudio } from "../state/studio";
import { zoom, type Viewed } from "./view";

const kSteps = { m: [0.1, 0.25, 0.5, 1, 2, 5, 10], ft: [0.3048, 0.6096, 1.524, 3.048, 6.096, 15.24] };
const kWidest = 130;

function ScaleBar({ scale }: { scale: number }) {
  const units = useStudio().settings.units.value;
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

export function ViewTools({ of }: { of: Viewed }) {
  return (
    <div class="plan-tools">
      <ScaleBar scale={of.view.value.scale} />
      <div class="button-group">
        <button class="icon-button" aria-label="Zoom out" title="Zoom out (-)" onClick={() => zoom(of, 1 / 1.25)}>
          <Icon name="minus" />
        </button>
        <button class="icon-button" aria-label="Zoom in" title="Zoom in (+)" onClick={() => zoom(of, 1.25)}>
          <Icon name="plus" />
        </button>
        <button class="icon-button" aria-label="Fit the room" title="Fit the room (0)" onClick={() => of.fit()}>
          <Icon name="fit" />
        </button>
      </div>
    </div>
  );
}
