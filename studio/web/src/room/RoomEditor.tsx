// SPDX-License-Identifier: GPL-3.0-or-later
// The page on which one draws a room of one's own, or changes the room of a document.
import { useEffect, useLayoutEffect, useMemo, useRef, useState } from "preact/hooks";
import type { GetDocumentResponse } from "../gen/flair/v1/studio_service_pb";
import { isOnFloor, piecesOf } from "../state/pieces";
import { goTo } from "../state/route";
import { useStudio } from "../state/studio";
import { BeginPanel } from "./BeginPanel";
import { Canvas } from "./Canvas";
import { ChosenPanel } from "./ChosenPanel";
import { DrawingContext } from "./context";
import { RoomDrawing } from "./controller";
import { Foot } from "./Foot";
import { keepSketch, keptSketch } from "./kept";
import { useDrawingKeys } from "./keys";
import { ShapePanel } from "./ShapePanel";
import { sketchOf } from "./to_room";

// A sketch of an older state of the room is of no use.
function keptName(shown: GetDocumentResponse | undefined): string {
  return shown?.document ? `${shown.document.id} ${shown.document.layoutId}` : "new";
}

function Editor({ shown }: { shown: GetDocumentResponse | undefined }) {
  const studio = useStudio();
  const drawing = useMemo(() => {
    const room = shown?.layout?.graph?.room;
    const made = new RoomDrawing(studio, room && sketchOf(room));
    const kept = keptSketch(keptName(shown));
    if (kept) made.commit(kept, "go on where you were");
    return made;
  }, [studio, shown]);
  useEffect(
    () =>
      drawing.history.subscribe(({ past, now }) => {
        if (past.length > 0) keepSketch(keptName(shown), now.state);
      }),
    [drawing],
  );
  useEffect(
    () => () => {
      if (drawing.picture.peek()) URL.revokeObjectURL(drawing.picture.peek()!.address);
    },
    [drawing],
  );
  const keys = useDrawingKeys(drawing);
  const below = useMemo(
    () => [...piecesOf(shown?.layout).values()].filter(isOnFloor),
    [shown],
  );
  const isClosed = drawing.sketch.value.isClosed;
  const body = useRef<HTMLDivElement>(null);
  // The button that was pressed is gone: keys are still meant for the panel. Not at once, for the focus may be on its way
  // from one field to the next.
  useLayoutEffect(() => {
    const timer = setTimeout(() => {
      if (document.activeElement === document.body) body.current?.focus({ preventScroll: true });
    });
    return () => clearTimeout(timer);
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
