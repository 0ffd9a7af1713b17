// SPDX-License-Identifier: GPL-3.0-or-later
// The page on which one draws a room of one's own, or changes the room of a document.
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { Icon } from "../app/Icon";
import type { Vec } from "../geometry/vec";
import type { GetDocumentResponse } from "../gen/flair/v1/studio_service_pb";
import { footprintOf, isOnFloor, piecesOf } from "../state/pieces";
import { goTo } from "../state/route";
import { useStudio } from "../state/studio";
import { BeginPanel } from "./BeginPanel";
import { Canvas } from "./Canvas";
import { ChosenPanel } from "./ChosenPanel";
import { DrawingContext, useDrawing } from "./context";
import { RoomDrawing } from "./controller";
import { useDrawingKeys } from "./keys";
import { saveChanged, saveNew } from "./save";
import { ShapePanel } from "./ShapePanel";
import { sketchOf } from "./to_room";

function Foot({ shown }: { shown: GetDocumentResponse | undefined }) {
  const drawing = useDrawing(),
    [isSent, setSent] = useState(false);
  const problems = drawing.problems.value,
    isClosed = drawing.sketch.value.isClosed;
  const done = async () => {
    setSent(true);
    const sketch = drawing.sketch.peek();
    await (shown ? saveChanged(drawing.studio, sketch, shown) : saveNew(drawing.studio, sketch));
    setSent(false);
  };
  const cancel = () => goTo(shown?.document ? { page: "document", id: shown.document.id } : { page: "start" });
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

function Editor({ shown }: { shown: GetDocumentResponse | undefined }) {
  const studio = useStudio();
  const drawing = useMemo(() => {
    const room = shown?.layout?.graph?.room;
    return new RoomDrawing(studio, room && sketchOf(room));
  }, [studio, shown]);
  useEffect(
    () => () => {
      if (drawing.picture.peek()) URL.revokeObjectURL(drawing.picture.peek()!.address);
    },
    [drawing],
  );
  const keys = useDrawingKeys(drawing);
  const below: Vec[][] = useMemo(
    () => [...piecesOf(shown?.layout).values()].filter(isOnFloor).map((piece) => footprintOf(piece)),
    [shown],
  );
  const isClosed = drawing.sketch.value.isClosed;
  const body = useRef<HTMLDivElement>(null);
  // The button that was pressed is gone: keys are still meant for the panel.
  useEffect(() => {
    if (document.activeElement === document.body) body.current?.focus({ preventScroll: true });
  });
  return (
    <DrawingContext.Provider value={drawing}>
      <main class="stage" aria-label="Room drawing">
        <Canvas below={below} />
      </main>
      <aside class="inspector room-panel" aria-label="Room" {...keys}>
        <div class="inspector-body" tabIndex={-1} ref={body}>
          {!isClosed && <BeginPanel />}
          {isClosed && !drawing.selection.value && <ShapePanel isNew={!shown} />}
          {isClosed && <ChosenPanel />}
        </div>
        <Foot shown={shown} />
      </aside>
    </DrawingContext.Provider>
  );
}

// `id` is of the document whose room is changed; empty for a new one.
export default function RoomEditor({ id }: { id: string }) {
  const studio = useStudio();
  const [shown, setShown] = useState<GetDocumentResponse | undefined>();
  useEffect(() => {
    let isGone = false;
    setShown(undefined);
    if (!id) return;
    void studio
      .told(() => studio.clients.studio.getDocument({ documentId: id }))
      .then((answer) => {
        if (isGone) return;
        if (answer?.layout?.graph?.room) setShown(answer);
        else goTo({ page: "start" });
      });
    return () => {
      isGone = true;
    };
  }, [id, studio]);
  if (id && !shown) return <main class="stage" aria-busy="true" />;
  return <Editor key={id} shown={shown} />;
}
