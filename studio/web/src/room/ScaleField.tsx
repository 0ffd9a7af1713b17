// SPDX-License-Identifier: GPL-3.0-or-later
// Sets the scale of a picture: two points, then how far apart they are.
import { useEffect, useRef } from "preact/hooks";
import { parseLength } from "../app/units";
import { useDrawing } from "./context";

export function ScaleField() {
  const drawing = useDrawing(),
    input = useRef<HTMLInputElement>(null);
  const points = drawing.scaling.value,
    units = drawing.studio.settings.units.value;
  useEffect(() => {
    if (points?.length === 2) input.current?.focus();
  }, [points?.length]);
  if (!points) return null;
  const end = () => drawing.element?.parentElement?.focus({ preventScroll: true });
  const send = (event: Event) => {
    event.preventDefault();
    const metres = parseLength(input.current!.value, units);
    if (metres === undefined || metres <= 0) return input.current!.setAttribute("aria-invalid", "true");
    drawing.setScale(metres);
    end();
  };
  const text = ["Click one end of a length that you know.", "Click its other end."][points.length];
  return (
    <form
      class="room-scale-bar"
      onSubmit={send}
      onKeyDown={(event) => {
        event.stopPropagation();
        if (event.key !== "Escape") return;
        drawing.scaling.value = undefined;
        end();
      }}
    >
      {text ? (
        <span>{text}</span>
      ) : (
        <>
          <label>
            It is{" "}
            <input
              ref={input}
              inputMode="decimal"
              placeholder={units === "m" ? "3.60" : "12′"}
              aria-label="Its real length"
            />{" "}
            {units} long
          </label>
          <button class="button is-primary" type="submit">
            Set
          </button>
        </>
      )}
      <button
        class="button"
        type="button"
        onClick={() => {
          drawing.scaling.value = undefined;
          end();
        }}
      >
        Cancel
      </button>
    </form>
  );
}
