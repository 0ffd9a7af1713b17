// SPDX-License-Identifier: GPL-3.0-or-later
// The room editor's state: the sketch with its history, what is selected, the tool in hand. Nothing is sent before
// "Done".
import { computed, signal } from "@preact/signals";
import { boxOf } from "../geometry/polygon";
import { add, sub, times, vec, type Vec } from "../geometry/vec";
import type { Gesture } from "../plan/gesture";
import { fitted, toRoom, toScreen, type View } from "../plan/view";
import type { Studio } from "../state/studio";
import { begun, pushed, redone, undone } from "./history";
import { nearestDirection, type PenPoint } from "./pen";
import { scaled, type Picture } from "./picture";
import { problemsOf } from "./problems";
import { emptySketch, freeKey, wallsOf, type Fixture, type Sketch, type WallLine } from "./sketch";
import { tidied } from "./walls";

// A corner nearer to the edge of the view than this many pixels makes it show more.
const kEdge = 48;

export type Tool = "select" | "door" | "window" | "socket";

export type Selection =
  | { readonly kind: "wall"; readonly key: string }
  | { readonly kind: "corner"; readonly key: string }
  | { readonly kind: "fixture"; readonly id: string };

// A length on the drawing that is being typed.
export type Typed =
  | { readonly kind: "wall"; readonly key: string }
  | { readonly kind: "gap"; readonly id: string; readonly side: "before" | "behind" };

export const sameSelection = (a: Selection | undefined, b: Selection | undefined): boolean =>
  JSON.stringify(a) === JSON.stringify(b);

export class RoomDrawing {
  readonly history;
  // What is shown while a gesture runs.
  readonly draft = signal<Sketch | undefined>(undefined);
  readonly sketch = computed<Sketch>(() => this.draft.value ?? this.history.value.now.state);
  readonly walls = computed<WallLine[]>(() => wallsOf(this.sketch.value));
  readonly selection = signal<Selection | undefined>(undefined);
  readonly tool = signal<Tool>("select");
  readonly pen = signal<PenPoint | undefined>(undefined);
  // The length of the wall under way as far as it is typed.
  readonly typed = signal("");
  // Where the tool in hand would put something.
  readonly ghost = signal<Fixture | undefined>(undefined);
  readonly lines = signal<ReadonlyArray<readonly [Vec, Vec]>>([]);
  readonly picture = signal<Picture | undefined>(undefined);
  // The points of a known length that were clicked, while its scale is being set.
  readonly scaling = signal<readonly Vec[] | undefined>(undefined);
  readonly editing = signal<Typed | undefined>(undefined);
  readonly hovered = signal<Selection | undefined>(undefined);
  readonly gesture = signal<Gesture | undefined>(undefined);
  readonly isSpaceDown = signal(false);
  readonly view = signal<View>({ scale: 80, left: 200, top: 500 });
  readonly width = signal(0);
  readonly height = signal(0);
  readonly mode = computed<"scale" | "pen" | Tool>(() => {
    if (this.scaling.value) return "scale";
    return this.sketch.value.isClosed ? this.tool.value : "pen";
  });
  readonly problems = computed(() => problemsOf(this.sketch.value, this.studio.settings.units.value));
  readonly isEdited = computed(() => this.history.value.past.length > 0);
  element: SVGSVGElement | null = null;
  private isViewOwn = false;

  constructor(
    readonly studio: Studio,
    first: Sketch = emptySketch,
  ) {
    this.history = signal(begun(first));
  }

  commit(sketch: Sketch, label: string): void {
    const before = this.history.peek().now.state;
    this.draft.value = undefined;
    this.lines.value = [];
    const next = tidied(sketch);
    if (next !== before) this.history.value = pushed(this.history.peek(), next, label);
    this.forgetTheGone();
    if (next.isClosed && !this.isViewOwn && !next.corners.every((corner) => this.isInView(corner, 0))) this.fit();
  }

  preview(sketch: Sketch, lines: ReadonlyArray<readonly [Vec, Vec]> = []): void {
    this.draft.value = sketch;
    this.lines.value = lines;
  }

  abandon(): void {
    this.draft.value = undefined;
    this.lines.value = [];
    this.ghost.value = undefined;
  }

  undo(): void {
    this.goTo(undone(this.history.peek()));
  }
  redo(): void {
    this.goTo(redone(this.history.peek()));
  }

  select(selection: Selection | undefined): void {
    this.selection.value = selection;
    this.editing.value = undefined;
  }

  take(tool: Tool): void {
    this.tool.value = tool;
    this.ghost.value = undefined;
    if (tool !== "select") this.select(undefined);
  }

  // The next corner of the walls under way; the first one again closes them.
  addCorner(point: PenPoint): void {
    const sketch = this.history.peek().now.state;
    this.typed.value = "";
    if (point.closes) return this.close();
    const last = sketch.corners.at(-1);
    if (last && Math.hypot(last.x - point.at.x, last.y - point.at.y) < 0.01) return;
    const corner = { x: point.at.x, y: point.at.y, wall: freeKey(sketch.corners) };
    this.commit({ ...sketch, corners: [...sketch.corners, corner] }, "draw a wall");
    this.pen.value = undefined;
    if (!this.isInView(corner, kEdge)) this.fit();
  }

  close(): void {
    const sketch = this.history.peek().now.state;
    this.typed.value = "";
    if (sketch.corners.length < 3) return;
    this.commit({ ...sketch, isClosed: true }, "close the walls");
    this.pen.value = undefined;
    this.fit();
  }

  // The way the wall under way goes, as a direction key wants it.
  direct(direction: Vec): void {
    const { corners } = this.sketch.peek(),
      last = corners.at(-1);
    if (!last) return;
    this.pen.value = { at: add(last, times(nearestDirection(corners, direction), 1)), inLine: [], closes: false };
  }

  // Ends the wall under way at a typed length.
  addTypedCorner(metres: number): void {
    const last = this.sketch.peek().corners.at(-1),
      to = this.pen.peek()?.at;
    if (!last || !to || metres <= 0) return;
    const along = sub(to, last),
      size = Math.hypot(along.x, along.y);
    if (size < 1e-6) return;
    const at = add(last, times(along, metres / size));
    this.addCorner({ at: vec(Math.round(at.x * 1e4) / 1e4, Math.round(at.y * 1e4) / 1e4), inLine: [], closes: false });
  }

  setScale(metres: number): void {
    const [a, b] = this.scaling.peek() ?? [],
      picture = this.picture.peek();
    if (a && b && picture) this.picture.value = scaled(picture, a, b, metres);
    this.scaling.value = undefined;
    this.fit();
  }

  pixelOf(event: { clientX: number; clientY: number }): Vec {
    const box = this.element!.getBoundingClientRect();
    return vec(event.clientX - box.left, event.clientY - box.top);
  }

  pointOf(event: { clientX: number; clientY: number }): Vec {
    return toRoom(this.view.peek(), this.pixelOf(event));
  }

  metresOf(pixels: number): number {
    return pixels / this.view.peek().scale;
  }

  // The walls and the picture; an empty page of some metres when there is neither.
  fit(): void {
    const width = this.width.peek(),
      height = this.height.peek();
    if (width === 0) return;
    const { corners, isClosed } = this.history.peek().now.state,
      picture = this.picture.peek();
    const points: Vec[] = isClosed ? [...corners] : [...corners, ...(picture ? [] : [vec(0, 0), vec(6, 5)])];
    if (picture && !isClosed) {
      points.push(
        picture.at,
        vec(
          picture.at.x + picture.widthPx * picture.metresPerPixel,
          picture.at.y - picture.heightPx * picture.metresPerPixel,
        ),
      );
    }
    const box = boxOf(points);
    const margin = picture && !isClosed ? 48 : Math.max(64, Math.min(width, height) * 0.13);
    this.view.value = fitted([box.min, box.max], width, height, margin);
    this.isViewOwn = false;
  }

  fitUnlessMoved(): void {
    if (!this.isViewOwn) this.fit();
  }

  setView(view: View): void {
    this.view.value = view;
    this.isViewOwn = true;
  }

  // Whether a point is seen, that many pixels away from the edges.
  private isInView(p: Vec, edge: number): boolean {
    const { x, y } = toScreen(this.view.peek(), p);
    return x >= edge && y >= edge && x <= this.width.peek() - edge && y <= this.height.peek() - edge;
  }

  private goTo(history: typeof this.history.value): void {
    this.abandon();
    this.typed.value = "";
    this.pen.value = undefined;
    this.history.value = history;
    this.forgetTheGone();
  }

  private forgetTheGone(): void {
    const { corners, fixtures } = this.history.peek().now.state;
    const one = this.selection.peek();
    const isThere =
      !one ||
      (one.kind === "fixture"
        ? fixtures.some(({ id }) => id === one.id)
        : corners.some(({ wall }) => wall === one.key));
    if (!isThere) this.selection.value = undefined;
    this.editing.value = undefined;
  }
}
