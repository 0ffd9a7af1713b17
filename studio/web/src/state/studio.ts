// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that the page knows: the documents, the open one, and whether the server is there.
import { effect, signal } from "@preact/signals";
import { createContext } from "preact";
import { useContext } from "preact/hooks";
import type { MessageInitShape } from "@bufbuild/protobuf";
import type { Clients } from "../api/clients";
import { newRequestId } from "../api/ids";
import { sentenceOf } from "../api/problems";
import { watchDocuments, type Connection } from "../api/watch";
import { JobState } from "../gen/flair/v1/job_pb";
import type { CreateDocumentRequestSchema, Document, WatchDocumentsResponse } from "../gen/flair/v1/studio_service_pb";
import { rename } from "./commands";
import { JobBook } from "./jobs";
import { OpenRoom } from "./open_room";
import { goTo, route } from "./route";
import { Settings } from "./settings";
import { Toasts } from "./toasts";

export type Source = NonNullable<MessageInitShape<typeof CreateDocumentRequestSchema>["source"]>;

const kTitleLetters = 60;

const shortened = (title: string): string =>
  title.length > kTitleLetters ? `${title.slice(0, kTitleLetters - 1).trimEnd()}…` : title || "Untitled room";

export class Studio {
  readonly settings = new Settings();
  readonly toasts = new Toasts();
  readonly jobs = new JobBook();
  readonly documents = signal<readonly Document[]>([]);
  // What was deleted since the page was opened, latest first: it can be put back until the server ends.
  readonly deleted = signal<readonly Document[]>([]);
  readonly isListed = signal(false);
  readonly open = signal<OpenRoom | undefined>(undefined);
  readonly connection = signal<Connection>("connecting");
  private readonly ending = new AbortController();
  // The rooms that were open, the latest last.
  private visited: readonly string[] = [];

  constructor(readonly clients: Clients) {
    effect(() => {
      const { page, id } = route.value;
      void this.openDocument(page === "document" ? id : "");
    });
    effect(() => {
      const open = this.open.value;
      if (open && !open.isBusy.value && !open.isHeld.value) this.catchUp();
    });
    void watchDocuments(clients, {
      connected: () => this.refresh(),
      heard: (event) => this.heard(event),
      state: (connection) => { this.connection.value = connection; },
    }, this.ending.signal);
  }

  stop(): void {
    this.ending.abort();
  }

  // A new document, which is then open. Undefined when the server would not make it.
  async create(source: Source): Promise<Document | undefined> {
    const made = await this.told(() => this.clients.studio.createDocument({ requestId: newRequestId(), source }));
    if (!made?.document) return undefined;
    this.put(made.document);
    goTo({ page: "document", id: made.document.id });
    return made.document;
  }

  // Deletes a document, and offers it back.
  async forget(document: Document): Promise<void> {
    const { id, title } = document, wasOpen = this.open.peek()?.id === id;
    if (!(await this.told(() => this.clients.studio.deleteDocument({ documentId: id })))) return;
    this.drop(id);
    this.toasts.offer(`“${shortened(title)}” is deleted.`,
      [{ label: "Put it back", run: () => void this.putBack(document, wasOpen) }]);
  }

  async putBack({ id }: Document, isShown = false): Promise<void> {
    const answer = await this.told(() => this.clients.studio.restoreDocument({ documentId: id }));
    if (answer?.document) this.put(answer.document);
    else this.deleted.value = this.deleted.value.filter((one) => one.id !== id);
    if (answer && isShown) goTo({ page: "document", id });
  }

  // A new document that is as another one, and is then open.
  async copy({ id, title }: Document): Promise<void> {
    const made = await this.create({ case: "documentId", value: id });
    if (made) this.toasts.note(`This is the copy. “${shortened(title)}” stays as it was.`);
  }

  // Gives a document another title, whether it is open or not.
  async rename({ id, revision }: Document, title: string): Promise<void> {
    const open = this.open.peek();
    if (open?.id === id) return void (await rename(open, title));
    const act = { case: "title", value: title } as const;
    const answer = await this.told(() => this.clients.studio.act({ documentId: id, revision, act }));
    if (answer?.document) this.put(answer.document);
  }

  // The answer of a call, or undefined after the user was told what went wrong.
  async told<T>(call: () => Promise<T>): Promise<T | undefined> {
    try {
      return await call();
    } catch (error) {
      this.toasts.error(sentenceOf(error));
      return undefined;
    }
  }

  private async openDocument(id: string): Promise<void> {
    const before = this.open.peek();
    if (before?.id === id) return;
    before?.close();
    this.open.value = undefined;
    if (!id) return;
    this.visited = [...this.visited.filter((one) => one !== id), id];
    const answer = await this.told(() => this.clients.studio.getDocument({ documentId: id }));
    if (route.peek().page !== "document" || route.peek().id !== id) return;
    if (!answer?.document) return goTo({ page: "start" });
    const room = new OpenRoom(answer.document, this.clients, this.toasts,
      () => this.settings.autoSettle.peek() === "on", () => this.settings.units.value);
    this.open.value = room;
    room.start(answer.layout);
    this.catchUp();
  }

  private async refresh(): Promise<void> {
    const { documents } = await this.clients.studio.listDocuments({ pageSize: 200 });
    this.documents.value = documents;
    this.isListed.value = true;
    this.catchUp();
  }

  // Shows what became of the open document while it was fetched or changed here.
  private catchUp(): void {
    const open = this.open.peek();
    const newest = this.documents.peek().find((one) => one.id === open?.id);
    if (open && newest) this.follow(open, newest);
  }

  private heard(event: WatchDocumentsResponse["event"]): void {
    if (event.case === "jobEvent") this.jobs.add(event.value);
    if (event.case === "deletedDocumentId") this.drop(event.value);
    if (event.case !== "document") return;
    this.put(event.value);
    this.catchUp();
  }

  // Somebody else changed the open document, or its job went on.
  private follow(open: OpenRoom, newest: Document): void {
    if (open.isBusy.peek() || open.isHeld.peek() || newest.revision <= open.document.peek().revision) return;
    const ended = newest.jobState !== JobState.QUEUED && newest.jobState !== JobState.RUNNING;
    if (ended || newest.layoutId !== open.document.peek().layoutId) void open.reload().catch(() => {});
    else open.document.value = newest;
  }

  private put(document: Document): void {
    const known = this.documents.value.find((one) => one.id === document.id);
    if (known && known.revision > document.revision) return;
    // What is known stays where it is in the list, under the pointer of whoever edits it.
    this.documents.value = known
      ? this.documents.value.map((one) => (one === known ? document : one))
      : [document, ...this.documents.value];
    this.deleted.value = this.deleted.value.filter((one) => one.id !== document.id);
  }

  private drop(id: string): void {
    const gone = this.documents.value.filter((one) => one.id === id);
    if (gone.length > 0) this.deleted.value = [...gone, ...this.deleted.value];
    this.documents.value = this.documents.value.filter((one) => one.id !== id);
    if (this.open.peek()?.id !== id) return;
    const before = this.visited.filter((one) => this.documents.peek().some((there) => there.id === one)).at(-1);
    goTo(before ? { page: "document", id: before } : { page: "start" });
  }
}

export const StudioContext = createContext<Studio | undefined>(undefined);

export function useStudio(): Studio {
  const studio = useContext(StudioContext);
  if (!studio) throw new Error("no studio above this component");
  return studio;
}
