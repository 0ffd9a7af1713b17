// SPDX-License-Identifier: GPL-3.0-or-later
// Before walls are closed: draw them, or take a rectangle, or trace a picture.
import { useState } from "preact/hooks";
import { Icon } from "../app/Icon";
import { figure, parseLength } from "../app/units";
import { useDrawing } from "./context";
import { PicturePanel } from "./PicturePanel";
import { RoomType } from "./RoomType";
import { rectangle } from "./sketch";

function Rectangle() {
  const drawing = useDrawing(),
    units = drawing.studio.settings.units.value;
  const [width, setWidth] = useState(figure(4, units)),
    [depth, setDepth] = useState(figure(3.5, units));
  const w = parseLength(width, units),
    d = parseLength(depth, units);
  const isGood = w !== undefined && d !== undefined && w >= 1 && d >= 1 && w <= 100 && d <= 100;
  const make = (event: Event) => {
    event.preventDefault();
    if (!isGood) return;
    drawing.commit(rectangle(w, d, drawing.sketch.peek()), "draw a rectangle");
    drawing.fit();
  };
  return (
    <form class="rectangle" onSubmit={make} onKeyDown={(event) => event.stopPropagation()}>
      <label class="field">
        <span>Width</span>
        <input
          value={width}
          inputMode="decimal"
          onFocus={(event) => event.currentTarget.select()}
          onInput={(event) => setWidth(event.currentTarget.value)}
        />
      </label>
      <span class="rectangle-by" aria-hidden="true">
        ×
      </span>
      <label class="field">
        <span>Depth</span>
        <input
          value={depth}
          inputMode="decimal"
          onFocus={(event) => event.currentTarget.select()}
          onInput={(event) => setDepth(event.currentTarget.value)}
        />
      </label>
      <button class="button" type="submit" disabled={!isGood}>
        Make
      </button>
    </form>
  );
}

export function BeginPanel() {
  const drawing = useDrawing(),
    { corners } = drawing.sketch.value;
  const isBegun = corners.length > 0;
  return (
    <>
      <header class="panel-head">
        <h2>{isBegun ? "Walls" : "Your own room"}</h2>
      </header>
      <div class="fields is-one"><RoomType /></div>
      <section>
        <h3 class="eyebrow">{isBegun ? "Go on" : "Draw the walls"}</h3>
        <ol class="steps">
          <li>
            Click corner after corner. Corners are square; <kbd>Alt</kbd> frees them.
          </li>
          <li>
            Or point the way and type a length: <kbd>3.2</kbd> <kbd>Enter</kbd>
          </li>
          <li>Click the first corner to close.</li>
        </ol>
        {isBegun && (
          <div class="panel-buttons">
            <button class="button" disabled={corners.length < 3} onClick={() => drawing.close()}>
              <Icon name="check" />
              Close
            </button>
            <button class="button" onClick={() => drawing.undo()}>
              <Icon name="undo" />
              Undo corner
            </button>
          </div>
        )}
      </section>
      {!isBegun && (
        <section>
          <h3 class="eyebrow">Or begin with a rectangle</h3>
          <Rectangle />
        </section>
      )}
      <PicturePanel title="Or trace a picture of a plan" />
    </>
  );
}
