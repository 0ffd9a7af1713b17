// SPDX-License-Identifier: GPL-3.0-or-later
import { useRef } from "preact/hooks";
import { Icon } from "../app/Icon";
import { useDrawing } from "./context";
import { readPicture } from "./picture";

export function PicturePanel({ title = "Picture of a plan" }: { title?: string }) {
  const drawing = useDrawing(),
    input = useRef<HTMLInputElement>(null),
    picture = drawing.picture.value;
  const take = async (file: File | undefined) => {
    if (!file) return;
    try {
      const before = drawing.picture.peek();
      drawing.picture.value = await readPicture(file);
      if (before) URL.revokeObjectURL(before.address);
      drawing.fit();
      drawing.scaling.value = [];
    } catch (error) {
      drawing.studio.toasts.error((error as Error).message);
    }
  };
  const remove = () => {
    if (picture) URL.revokeObjectURL(picture.address);
    drawing.picture.value = undefined;
    drawing.scaling.value = undefined;
  };
  return (
    <section class="picture">
      <h3 class="eyebrow">{picture ? "Picture below" : title}</h3>
      <input
        ref={input}
        type="file"
        accept="image/png,image/jpeg,image/webp,image/gif"
        hidden
        aria-label="Picture of a plan"
        onChange={(event) => {
          void take(event.currentTarget.files?.[0]);
          event.currentTarget.value = "";
        }}
      />
      {picture ? (
        <>
          <p class="picture-name">{picture.name}</p>
          <label class="weight">
            <span>Opacity</span>
            <input
              type="range"
              min={0.1}
              max={1}
              step={0.05}
              value={picture.opacity}
              onInput={(event) => {
                drawing.picture.value = { ...picture, opacity: Number(event.currentTarget.value) };
              }}
            />
          </label>
          <div class="panel-buttons">
            <button
              class="button"
              onClick={() => {
                drawing.scaling.value = [];
              }}
            >
              <Icon name="ruler" />
              Set the scale
            </button>
            <button class="button" onClick={remove}>
              <Icon name="trash" />
              Remove
            </button>
          </div>
        </>
      ) : (
        <>
          <button class="button" onClick={() => input.current!.click()}>
            <Icon name="picture" />
            Choose a picture
          </button>
          <p class="hint">A scan or a photo. It stays in this browser.</p>
        </>
      )}
    </section>
  );
}
