// SPDX-License-Identifier: GPL-3.0-or-later
// The view beside the plan: the same selection, fetched anew some time after each act.
import { useEffect, useRef, useState } from "preact/hooks";
import { isUnknownCall, sentenceOf } from "../api/problems";
import { Icon } from "../app/Icon";
import { DocumentFormat } from "../gen/flair/v1/studio_service_pb";
import type { OpenRoom } from "../state/open_room";
import { theName, type Piece } from "../state/pieces";
import { useStudio, type Studio } from "../state/studio";
import type { Sight } from "./camera";
import { Traced } from "./Traced";
import { fromPiece } from "./places";
import { View3d, type Mode, type Remembered } from "./view3d";

const kPause = 350;

// By room, for as long as the page is open.
const remembered = new Map<string, Remembered>();

// Keeps the view at what the document shows.
function followDocument(studio: Studio, room: OpenRoom, view: View3d, told: (state: string) => void): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined, shown = "", isEnded = false;
  const fetchScene = async () => {
    const { layoutId } = room.document.peek();
    try {
      const { content } = await studio.clients.studio.exportDocument({
        documentId: room.id,
        format: DocumentFormat.SCENE_GLB,
      });
      if (isEnded) return;
      await view.load(content);
      shown = layoutId;
      told("");
    } catch (error) {
      if (!isEnded) told(isUnknownCall(error) ? "This server shows no view." : sentenceOf(error));
    }
  };
  const unsubscribe = room.document.subscribe(({ layoutId }) => {
    if (!layoutId || layoutId === shown) return;
    clearTimeout(timer);
    timer = setTimeout(fetchScene, shown ? kPause : 0);
  });
  return () => {
    isEnded = true;
    clearTimeout(timer);
    unsubscribe();
  };
}

function pick(room: OpenRoom, id: string, isAdding: boolean): void {
  const before = room.selection.peek();
  if (!id) return isAdding ? undefined : room.select([]);
  if (!isAdding) return room.select([id]);
  room.select(before.has(id) ? [...before].filter((one) => one !== id) : [...before, id]);
}

export default function Scene({ room }: { room: OpenRoom }) {
  const studio = useStudio();
  const host = useRef<HTMLDivElement>(null), view = useRef<View3d>();
  const memory = remembered.get(room.id) ?? { mode: "orbit" };
  remembered.set(room.id, memory);
  const [mode, setMode] = useState<Mode>(memory.mode), [hasWalked, setWalked] = useState(false);
  const [state, setState] = useState("Loading the view...");
  const [traced, setTraced] = useState<{ sight: Sight | undefined; isWithin: boolean }>();
  useEffect(() => {
    let made: View3d;
    try {
      made = new View3d(host.current!, {
        remembered: memory,
        furnished: () => {
          const shape = room.layout.peek()?.graph?.room;
          return shape && { room: shape, pieces: room.pieces.peek() };
        },
        onPick: (id, isAdding) => pick(room, id, isAdding),
        onMode: setMode,
        onStep: () => setWalked(true),
      });
    } catch {
      return setState("This browser shows nothing in three dimensions: it has no WebGL.");
    }
    view.current = made;
    const observer = new ResizeObserver(() => made.resize());
    observer.observe(host.current!);
    const ends = [followDocument(studio, room, made, setState), room.selection.subscribe((ids) => made.select(ids))];
    return () => {
      observer.disconnect();
      ends.forEach((end) => end());
      made.dispose();
    };
  }, [room, studio]);
  const change = (to: Mode) => {
    setMode(to);
    view.current?.setMode(to);
  };
  const chosen = [...room.selection.value].flatMap((id) => room.pieces.value.get(id) ?? []);
  const seat = !state && chosen.length === 1 ? chosen[0] : undefined;
  const lookFrom = (piece: Piece) => {
    setMode("walk");
    view.current?.lookFrom(fromPiece(piece, room.floor.peek()));
  };
  const trace = () => setTraced({ sight: state ? undefined : view.current?.sight, isWithin: mode === "walk" });
  return (
    <div class="scene" ref={host} role="region" aria-label="The room in three dimensions">
      {state && <p class="scene-state">{state}</p>}
      <div class="scene-tools">
        {!state && mode === "walk" && !hasWalked && (
        <p class="scene-hint">Walk with W A S D, turn with the arrow keys, with Shift faster; drag to look around; double click on the floor to go there.</p>
        )}
        <div class="segmented" role="group" aria-label="How to look">
          <button aria-pressed={mode === "orbit"} onClick={() => change("orbit")} title="Look from outside">
            <Icon name="orbit" />
            Orbit
          </button>
          <button
            aria-pressed={mode === "walk"}
            onClick={() => change("walk")}
            title="Walk: W A S D, with Shift faster; drag to look around"
          >
            <Icon name="walk" />
            Walk
          </button>
        </div>
        {seat && (
          <button class="button" title="See the room as from there" onClick={() => lookFrom(seat)}>
            <Icon name="pointer" />
            From {theName(seat.object)}
          </button>
        )}
        <button class="button" title="A picture with real light and shadows, from where you look now" onClick={trace}>
          <Icon name="camera" />
          Ray-trace
        </button>
      </div>
      {traced && <Traced room={room} {...traced} onClose={() => setTraced(undefined)} />}
    </div>
  );
}
