// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with the room under way, and the ways out of the editor.
import { useState } from "preact/hooks";
import { Icon } from "../app/Icon";
import type { GetDocumentResponse } from "../gen/flair/v1/studio_service_pb";
import { goTo } from "../state/route";
import { useDrawing } from "./context";
import { forgetSketch } from "./kept";
import { saveChanged, saveNew } from "./save";

export function Foot({ shown }: { shown: GetDocumentResponse | undefined }) {
  const drawing = useDrawing(),
    [isSent, setSent] = useState(false);
  const problems = drawing.problems.value,
    isClosed = drawing.sketch.value.isClosed;
  const done = async () => {
    setSent(true);
    const sketch = drawing.sketch.peek();
    const isSaved = await (shown ? saveChanged(drawing.studio, sketch, shown) : saveNew(drawing.studio, sketch));
    if (isSaved) forgetSketch();
    setSent(false);
  };
  const cancel = () => {
    forgetSketch();
    goTo(shown?.document ? { page: "document", id: shown.document.id } : { page: "start" });
  };
  const isUnchanged = shown !== undefined && !drawing.isEdited.value;
  return (
    <footer class="room-foot">
      {problems.length > 0 && (
        <ul class="notices" aria-live="polite">
          {problems.slice(0, 4).map(({ text, about }) => (
            <li key={text} class="notice is-bad">
              {about[0] === undefined ? (
                text
              ) : (
                <button
                  onClick={() =>
                    drawing.select(
                      /^w\d+$/.test(about[0]!) ? { kind: "wall", key: about[0]! } : { kind: "fixture", id: about[0]! },
                    )
                  }
                >
                  {text}
                </button>
              )}
            </li>
          ))}
        </ul>
      )}
      <div class="room-foot-buttons">
        <button class="button" onClick={cancel}>
          Cancel
        </button>
        <button
          class="button is-primary"
          disabled={!isClosed || problems.length > 0 || isSent || isUnchanged}
          onClick={() => void done()}
          title={isClosed ? undefined : "Close the walls first"}
        >
          <Icon name="check" />
          Done
        </button>
      </div>
    </footer>
  );
}
