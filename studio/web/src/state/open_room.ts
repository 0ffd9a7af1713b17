// SPDX-License-Identifier: GPL-3.0-or-later
// The document that is open: what it shows, what is selected in it, and the one way to change it.
import { batch, computed, signal, type ReadonlySignal } from "@preact/signals";
import type { MessageInitShape } from "@bufbuild/protobuf";
import type { Units } from "../app/units";
import type { Clients } from "../api/clients";
import { isConflict, isNothingToDo, isUnknownCall, sentenceOf } from "../api/problems";
import type { Pose } from "../geometry/footprint";
import { spoken, spokenThroughout, wallWords } from "../geometry/wall_names";
import { noteOf, type Demand, type Note } from "../inspector/note";
import type { PlanParts } from "../gen/flair/v1/renderer_service_pb";
import { Severity } from "../gen/flair/v1/provenance_pb";
import type { SolvedLayout } from "../gen/flair/v1/solved_layout_pb";
import type { ActRequestSchema, ActResponse, Document } from "../gen/flair/v1/studio_service_pb";
import { effectOf, type Effect } from "./effects";
import { Judging } from "./judging";
import { animate } from "./motion";
import { floorOf, piecesOf, wallsOf, type Poses } from "./pieces";
import { isDrawnAlike } from "./structure";
import { VariantSearch } from "../variants/search";
import type { ToastAct, Toasts } from "./toasts";

export type Act = NonNullable<MessageInitShape<typeof ActRequestSchema>["act"]>;

export interface Explanation {
  readonly note: Note;
  readonly notAsAsked: readonly string[];
}

// Acts whose effects are plain to see: moves are judged on their way.
const kUntold = new Set<string>(["move", "undo", "redo", "title", "room"]);

const kNothing: Poses = new Map();

export class OpenRoom {
  readonly document;
  readonly layout = signal<SolvedLayout | undefined>(undefined);
  readonly parts = signal<PlanParts | undefined>(undefined);
  // As the server gives it, and as it is read here.
  private readonly told = signal<Explanation | undefined>(undefined);
  readonly explanation = computed(() => spokenThroughout(this.told.value, this.wallWords.value, this.units()));
  // Ids of pieces.
  readonly selection = signal<ReadonlySet<string>>(new Set());
  readonly hovered = signal("");
  // The sentence that the pointer is on, whose pieces and distances are shown.
  readonly pointedAt = signal<Demand | undefined>(undefined);
  // Where pieces are seen while they are dragged or on their way; those that are not named are where the layout says.
  readonly draft = signal<Poses>(kNothing);
  // An act is on its way, or waits for the one before.
  readonly isBusy = signal(false);
  // Pieces are in hand; what others do meanwhile is shown afterwards.
  readonly isHeld = signal(false);
  // Of the last act.
  readonly effect = signal<Effect | undefined>(undefined);
  readonly pieces = computed(() => piecesOf(this.layout.value));
  readonly floor = computed(() => floorOf(this.layout.value));
  readonly outcomes = computed(() => new Map(this.layout.value?.edgeOutcomes.map((one) => [one.edgeId, one])));
  // What walls are called that have but a number.
  readonly wallWords = computed(() => wallWords(wallsOf(this.layout.value?.graph?.room)));
  readonly judging: Judging;
  readonly search: VariantSearch;
  private readonly poses = new Map<string, ReadonlySignal<Pose | undefined>>();
  private queue: Promise<unknown> = Promise.resolve();
  private waiting = 0;
  private endMotion = () => {};
  private isClosed = false;
  private readonly offers: number[] = [];

  // `settlesAlone`: whether every change is settled without being asked.
  constructor(document: Document, private readonly clients: Clients, private readonly toasts: Toasts,
    readonly settlesAlone: () => boolean, private readonly units: () => Units = () => "m") {
    this.document = signal(document);
    this.judging = new Judging((placements) => clients.studio.judge(
      { documentId: this.id, revision: this.document.peek().revision, placements }));
    this.search = new VariantSearch(this, clients);
  }

  // The document with other layouts to take; what it shows is the same.
  found(document: Document): void {
    if (document.revision > this.document.peek().revision) this.document.value = document;
  }

  // With acts, an offer that can be taken by a click.
  tell(note: string, acts: readonly ToastAct[] = []): void {
    if (acts.length > 0) this.offers.push(this.toasts.offer(note, acts));
    else this.toasts.note(note);
  }

  // Says that pieces stay as they are because they are locked.
  tellLocked(text: string, unlock: () => void): void {
    this.toasts.warn(text, [{ label: "Unlock", run: unlock }]);
  }

  // What was offered about acts that are undone.
  withdrawOffers(): void {
    for (const id of this.offers.splice(0)) this.toasts.dismiss(id);
  }

  get id(): string {
    return this.document.peek().id;
  }

  // Where a piece is seen. Who reads it is told only when that very piece moves.
  poseOf(id: string): Pose | undefined {
    let pose = this.poses.get(id);
    if (!pose) {
      pose = computed(() => this.draft.value.get(id) ?? this.pieces.value.get(id)?.pose);
      this.poses.set(id, pose);
    }
    return pose.value;
  }

  close(): void {
    this.isClosed = true;
    this.search.cancel();
    this.endMotion();
  }

  // What was pointed at in a list is gone with it, and no leaving of the pointer is told.
  select(ids: Iterable<string>): void {
    batch(() => {
      this.selection.value = new Set(ids);
      this.hovered.value = "";
      this.pointedAt.value = undefined;
    });
  }

  // A text of the server in the words of this room.
  spoken(text: string): string {
    return spoken(text, this.wallWords.value, this.units());
  }

  // Shows the first that is known of it.
  start(layout: SolvedLayout | undefined): void {
    this.show(this.document.peek(), layout);
  }

  // Fetches the document anew, as after a change by somebody else.
  async reload(): Promise<void> {
    const { document, layout } = await this.clients.studio.getDocument({ documentId: this.id });
    const isOld = document && document.revision < this.document.peek().revision;
    if (document && !isOld && !this.isClosed) this.show(document, layout);
  }

  // Changes the document; one act after the other. Errors and remarks are told to the user, by a toast unless `tell`
  // does; after an error the answer is undefined.
  act(act: Act, tell?: (text: string) => void): Promise<ActResponse | undefined> {
    this.waiting += 1;
    this.isBusy.value = true;
    const answer = this.queue.then(() => this.send(act, tell)).finally(() => {
      this.waiting -= 1;
      this.isBusy.value = this.waiting > 0;
    });
    this.queue = answer;
    return answer;
  }

  private async send(
    act: Act,
    tell = (text: string) => this.toasts.error(text),
    isAgain = false,
  ): Promise<ActResponse | undefined> {
    try {
      const { revision } = this.document.peek();
      const response = await this.clients.studio.act({ documentId: this.id, revision, act });
      const before = this.layout.peek();
      const known = new Set(before?.diagnostics.map((one) => one.message));
      if (response.document && !this.isClosed) this.show(response.document, response.layout);
      const isTold = !kUntold.has(act.case ?? "");
      this.effect.value = response.layout && isTold ? effectOf(before, response.layout) : undefined;
      // What a list or the card tells is not told by a toast as well.
      const told = [...(this.effect.peek()?.lost ?? []).map(({ text }) => text.replace(/\.$/, "")),
        ...(response.layout?.metrics?.findings ?? []).map((one) => one.message.replace(/\.$/, ""))];
      for (const { severity, message: said } of response.diagnostics) {
        const message = this.spoken(said), isNew = !known.has(said) && !told.some((one) => said.includes(one));
        if (severity >= Severity.WARNING && isNew) tell(message);
        else if (act.case === "room") this.toasts.note(message);
      }
      return response;
    } catch (error) {
      if (isConflict(error)) {
        const { layoutId } = this.document.peek();
        await this.reload().catch(() => {});
        // Only its title or its job has changed: nothing is in the way.
        if (!isAgain && layoutId === this.document.peek().layoutId) return await this.send(act, tell, true);
        this.toasts.error(
          "The room was changed in another window meanwhile. Here is its newest state; please try again.",
        );
      } else {
        this.show(this.document.peek(), this.layout.peek());
        if (isNothingToDo(error)) this.toasts.note(sentenceOf(error));
        else tell(sentenceOf(error));
      }
      return undefined;
    }
  }

  private show(document: Document, next: SolvedLayout | undefined): void {
    const before = this.layout.peek();
    if (next && !next.graph && before) next.graph = before.graph;
    const seen = new Map([...this.pieces.peek()].map(([id, piece]) => [id, this.draft.peek().get(id) ?? piece.pose]));
    this.endMotion();
    batch(() => {
      this.document.value = document;
      this.layout.value = next ?? before;
      this.judging.end();
      const pieces = this.pieces.value;
      if ([...this.selection.peek()].some((id) => !pieces.has(id))) {
        this.select([...this.selection.peek()].filter((id) => pieces.has(id)));
      }
      const goal = new Map([...pieces].map(([id, piece]) => [id, piece.pose]));
      this.endMotion = animate(
        seen,
        goal,
        (poses) => {
          this.draft.value = poses;
        },
        () => {
          this.draft.value = kNothing;
        },
      );
    });
    if (!next) return;
    if (!this.parts.peek() || !isDrawnAlike(before, next)) void this.redraw();
    void this.explain();
  }

  private async redraw(): Promise<void> {
    try {
      const { revision, parts } = await this.clients.studio.drawDocument({ documentId: this.id });
      if (revision === this.document.peek().revision || !this.parts.peek()) this.parts.value = parts;
    } catch (error) {
      // The page then draws plain outlines.
      if (!isUnknownCall(error)) this.toasts.error(sentenceOf(error));
    }
  }

  private async explain(): Promise<void> {
    try {
      const { revision, note, notAsAsked } = await this.clients.studio.explain({ documentId: this.id });
      if (revision !== this.document.peek().revision) return;
      this.told.value = { note: noteOf(note), notAsAsked: [...notAsAsked] };
    } catch (error) {
      if (!isUnknownCall(error)) this.toasts.error(sentenceOf(error));
    }
  }
}
