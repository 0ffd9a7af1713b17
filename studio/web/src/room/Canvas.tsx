// SPDX-License-Identifier: GPL-3.0-or-later
// The drawing of the room under way: grid, picture, floor, walls, what is in them, and handles.
import { useComputed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { Icon } from "../app/Icon";
import { add, middle, times, vec, type Vec } from "../geometry/vec";
import { pixelPoints } from "../plan/overlay/pixels";
import { toRoom, toScreen, zoomedAt } from "../plan/view";
import { usePlanWheel } from "../plan/wheel";
import { addCornerOn, fixtureOf, nameOfWall } from "./acts";
import { useDrawing } from "./context";
import { sameSelection, type RoomDrawing } from "./controller";
import { DrawnFixture } from "./DrawnFixture";
import { useDrawingKeys } from "./keys";
import { LengthField } from "./LengthField";
import { Lengths } from "./Lengths";
import { useDrawingPointer } from "./pointer";
import { ScaleField } from "./ScaleField";
import { kWallThickness, spanOf } from "./shapes";
import { Toolbar } from "./Toolbar";

function Grid() {
  const drawing = useDrawing(), view = drawing.view.value, width = drawing.width.value, height = drawing.height.value;
  if (width === 0) return null;
  const step = view.scale > 55 ? 0.5 : view.scale > 22 ? 1 : 5;
  const low = toRoom(view, vec(0, height)), high = toRoom(view, vec(width, 0));
  const marks = (from: number, to: number) =>
    Array.from({ length: Math.max(0, Math.floor(to / step) - Math.ceil(from / step) + 1) }, (_, i) => (Math.ceil(from / step) + i) * step);
  const name = (at: number) => (Math.abs(at / (step * 2) - Math.round(at / (step * 2))) < 1e-6 ? "room-grid is-strong" : "room-grid");
  return (
    <g aria-hidden="true">
      {marks(low.x, high.x).map((x) => { const at = toScreen(view, vec(x, 0)).x; return <line key={`x${x}`} class={name(x)} x1={at} x2={at} y1={0} y2={height} />; })}
      {marks(low.y, high.y).map((y) => { const at = toScreen(view, vec(0, y)).y; return <line key={`y${y}`} class={name(y)} y1={at} y2={at} x1={0} x2={width} />; })}
    </g>
  );
}

function Underlay() {
  const drawing = useDrawing(), picture = drawing.picture.value, view = drawing.view.value;
  if (!picture) return null;
  const at = toScreen(view, picture.at), scale = picture.metresPerPixel * view.scale;
  return <image href={picture.address} x={at.x} y={at.y} width={picture.widthPx * scale} height={picture.heightPx * scale}
    opacity={picture.opacity} preserveAspectRatio="none" pointer-events="none" />;
}

function Walls() {
  const drawing = useDrawing(), { corners, isClosed, fixtures } = drawing.sketch.value;
  const view = drawing.view.value, walls = drawing.walls.value;
  const selected = drawing.selection.value, hovered = drawing.hovered.value;
  const wrong = new Set(drawing.problems.value.flatMap(({ about }) => about));
  const points = pixelPoints(view, corners), thickness = kWallThickness * view.scale;
  const isTraced = drawing.picture.value !== undefined;
  const byKey = new Map(walls.map((wall) => [wall.key, wall]));
  return (
    <>
      {isClosed && <polygon class="room-walls" points={points} stroke-width={2 * thickness} />}
      {isClosed && <polygon class={isTraced ? "room-floor is-traced" : "room-floor"} points={points} />}
      {!isClosed && corners.length > 0 && <polyline class="room-line" points={points} />}
      {walls.map((wall) => {
        const state = [selected?.kind === "wall" && selected.key === wall.key ? "is-selected" : "",
          hovered?.kind === "wall" && hovered.key === wall.key ? "is-hovered" : "", wrong.has(wall.key) ? "is-wrong" : ""].join(" ");
        const a = toScreen(view, wall.a), b = toScreen(view, wall.b);
        const out = times(wall.inward, -kWallThickness);
        return (
          <g key={wall.key} class={`room-wall ${state}`} data-wall={wall.key}>
            {isClosed && <polygon class="room-wall-band" points={pixelPoints(view, [wall.a, wall.b, add(wall.b, out), add(wall.a, out)])} />}
            <line class="hit-line" x1={a.x} y1={a.y} x2={b.x} y2={b.y} />
          </g>
        );
      })}
      {[...fixtures, ...(drawing.ghost.value ? [drawing.ghost.value] : [])].map((fixture, i) => {
        const wall = byKey.get(fixture.wall);
        if (!wall) return null;
        const isGhost = i === fixtures.length;
        const one = { kind: "fixture", id: fixture.id } as const;
        const state = [isGhost ? "is-ghost" : "", sameSelection(selected, one) ? "is-selected" : "",
          sameSelection(hovered, one) ? "is-hovered" : "", wrong.has(fixture.id) ? "is-wrong" : ""].join(" ");
        return <DrawnFixture key={isGhost ? "ghost" : fixture.id} fixture={fixture} wall={wall} state={state} />;
      })}
    </>
  );
}

function Pen() {
  const drawing = useDrawing(), view = drawing.view.value, pen = drawing.pen.value;
  const { corners } = drawing.sketch.value, last = corners.at(-1), first = corners[0];
  if (drawing.mode.value !== "pen") return null;
  const at = pen && toScreen(view, pen.at), from = last && toScreen(view, last), start = first && toScreen(view, first);
  return (
    <g pointer-events="none">
      {pen?.inLine.map((corner) => { const p = toScreen(view, corner); return <line key={`${corner.x} ${corner.y}`} class="guide" x1={p.x} y1={p.y} x2={at!.x} y2={at!.y} />; })}
      {from && at && <line class="room-line is-pen" x1={from.x} y1={from.y} x2={at.x} y2={at.y} />}
      {corners.map((corner) => { const p = toScreen(view, corner); return <circle key={corner.wall} class="room-dot" cx={p.x} cy={p.y} r={3.5} />; })}
      {start && corners.length >= 3 && <circle class={pen?.closes ? "room-close is-hit" : "room-close"} cx={start.x} cy={start.y} r={9} />}
      {at && !pen.closes && <circle class="room-dot is-pen" cx={at.x} cy={at.y} r={4} />}
    </g>
  );
}

function Square({ at, name, corner, end, cursor }: { at: Vec; name: string; corner?: string; end?: string; cursor?: string }) {
  return (
    <g class={`grip ${name}`} data-corner={corner} data-end={end} data-cursor={cursor}>
      <circle class="hit" cx={at.x} cy={at.y} r={13} />
      <rect x={at.x - 4.5} y={at.y - 4.5} width={9} height={9} rx={2} />
    </g>
  );
}

function Handles() {
  const drawing = useDrawing(), view = drawing.view.value, sketch = drawing.sketch.value, one = drawing.selection.value;
  if (!sketch.isClosed || drawing.mode.value !== "select") return null;
  const wall = one?.kind === "wall" ? drawing.walls.value.find(({ key }) => key === one.key) : undefined;
  const fixture = one?.kind === "fixture" ? fixtureOf(sketch, one.id) : undefined;
  const host = fixture && fixture.kind !== "socket" ? drawing.walls.value.find(({ key }) => key === fixture.wall) : undefined;
  const span = host && fixture && fixture.kind !== "socket" ? spanOf(fixture, host) : undefined;
  const half = wall && toScreen(view, add(middle(wall.a, wall.b), times(wall.inward, -kWallThickness / 2)));
  return (
    <>
      {sketch.corners.map((corner) => (
        <Square key={corner.wall} at={toScreen(view, corner)} corner={corner.wall}
          name={one?.kind === "corner" && one.key === corner.wall ? "is-corner is-chosen" : "is-corner"} />
      ))}
      {half && wall!.length * view.scale > 60 && (
        <g class="room-add" data-field="" role="button" aria-label={`Add a corner to ${nameOfWall(sketch, wall!.key)}`}
          onClick={() => addCornerOn(drawing, wall!.index, Math.round(wall!.length * 50) / 100)}>
          <title>Add a corner here</title>
          <circle cx={half.x} cy={half.y} r={9} /><path d={`M${half.x - 4} ${half.y}h8M${half.x} ${half.y - 4}v8`} />
        </g>
      )}
      {span && <Square at={toScreen(view, span.start)} end="start" name="" />}
      {span && <Square at={toScreen(view, span.end)} end="end" name="" />}
    </>
  );
}

function Guides() {
  const drawing = useDrawing(), view = drawing.view.value, points = drawing.scaling.value;
  const marks = points?.map((p) => toScreen(view, p)) ?? [];
  return (
    <g pointer-events="none">
      {drawing.lines.value.map(([p, q], i) => {
        const a = toScreen(view, p), b = toScreen(view, q);
        return <line key={i} class="guide" x1={a.x} y1={a.y} x2={b.x} y2={b.y} />;
      })}
      {marks.length === 2 && <line class="guide is-wall" x1={marks[0]!.x} y1={marks[0]!.y} x2={marks[1]!.x} y2={marks[1]!.y} />}
      {marks.map((at, i) => <g key={i}><circle class="room-scale" cx={at.x} cy={at.y} r={8} /><circle class="room-scale-dot" cx={at.x} cy={at.y} r={2} /></g>)}
    </g>
  );
}

// What a click would do.
function Advice() {
  const drawing = useDrawing(), mode = drawing.mode.value, { corners } = drawing.sketch.value;
  const texts = {
    scale: "", select: "",
    pen: corners.length === 0 ? "Click where the first corner is." : corners.length < 3 ? "Click the next corner, or type how far it is."
      : "Click the next corner. The first one closes the room.",
    door: "Click a wall to place the door.", window: "Click a wall to place the window.", socket: "Click a wall to place the socket.",
  };
  return <p class="room-advice" aria-live="polite">{texts[mode]}</p>;
}

const kSteps = { m: [0.1, 0.5, 1, 2, 5, 10], ft: [0.3048, 0.9144, 1.524, 3.048, 6.096, 15.24] };

function ScaleBar() {
  const drawing = useDrawing(), units = drawing.studio.settings.units.value, { scale } = drawing.view.value;
  const bar = useRef<HTMLDivElement>(null);
  const metres = [...kSteps[units]].reverse().find((step) => step * scale <= 130) ?? kSteps[units][0]!;
  useEffect(() => { bar.current!.style.width = `${metres * scale}px`; }, [metres, scale]);
  const text = units === "m" ? `${metres} m` : `${Math.round(metres / 0.3048)} ft`;
  return <div class="scale-bar" aria-label={`Scale: this bar is ${text} long`}><div ref={bar} /><span>{text}</span></div>;
}

function useSize(drawing: RoomDrawing, host: { current: HTMLDivElement | null }): void {
  useEffect(() => {
    const observer = new ResizeObserver(([entry]) => {
      drawing.width.value = entry!.contentRect.width;
      drawing.height.value = entry!.contentRect.height;
      drawing.fitUnlessMoved();
    });
    observer.observe(host.current!);
    return () => observer.disconnect();
  }, [drawing]);
}

// `below` is drawn on the floor: what stands in a room that is edited.
export function Canvas({ below }: { below: ReadonlyArray<readonly Vec[]> }) {
  const drawing = useDrawing(), host = useRef<HTMLDivElement>(null);
  useSize(drawing, host);
  usePlanWheel(drawing, host);
  const pointer = useDrawingPointer(drawing), keys = useDrawingKeys(drawing);
  useEffect(() => host.current!.focus({ preventScroll: true }), []);
  const cursor = useComputed(() => drawing.gesture.value?.cursor ?? (drawing.isSpaceDown.value ? "grab"
    : drawing.mode.value === "select" ? (drawing.hovered.value ? "move" : "default") : "crosshair"));
  useEffect(() => cursor.subscribe((value) => { host.current!.style.cursor = value; }), [cursor]);
  const view = drawing.view.value;
  const zoom = (factor: number) => drawing.setView(zoomedAt(drawing.view.peek(), vec(drawing.width.peek() / 2, drawing.height.peek() / 2), factor));
  return (
    <div class="plan room-canvas" ref={host} tabIndex={0} role="application" {...keys}
      aria-label="Drawing of the room. Arrows and a typed length draw a wall, Enter ends it; arrows move what is selected.">
      <svg class="plan-drawing" ref={(element) => { drawing.element = element; }} {...pointer}>
        <Grid />
        <Underlay />
        <Walls />
        {below.map((polygon, i) => <polygon key={i} class="room-piece" points={pixelPoints(view, polygon)} />)}
        <Guides />
        <Pen />
        <Lengths />
        <Handles />
      </svg>
      <LengthField />
      <ScaleField />
      <Toolbar />
      <Advice />
      <div class="plan-tools">
        <ScaleBar />
        <div class="button-group">
          <button class="icon-button" aria-label="Zoom out" title="Zoom out (-)" onClick={() => zoom(0.8)}><Icon name="minus" /></button>
          <button class="icon-button" aria-label="Zoom in" title="Zoom in (+)" onClick={() => zoom(1.25)}><Icon name="plus" /></button>
          <button class="icon-button" aria-label="Fit the room" title="Fit the room (0)" onClick={() => drawing.fit()}><Icon name="fit" /></button>
        </div>
      </div>
    </div>
  );
}
