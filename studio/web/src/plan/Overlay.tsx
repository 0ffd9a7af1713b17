// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn above the plan in pixels, so that it is as fine at every zoom.
import { ClearSpaces } from "./overlay/ClearSpaces";
import { Clearances } from "./overlay/Clearances";
import { Findings } from "./overlay/Findings";
import { Guides } from "./overlay/Guides";
import { Handles } from "./overlay/Handles";
import { Labels } from "./overlay/Labels";
import { Lines } from "./overlay/Lines";
import { Outlines } from "./overlay/Outlines";
import { WallSizes } from "./overlay/WallSizes";

export function Overlay() {
  return (
    <g class="overlay">
      <WallSizes />
      <ClearSpaces />
      <Findings />
      <Labels />
      <Lines />
      <Guides />
      <Outlines />
      <Clearances />
      <Handles />
    </g>
  );
}
