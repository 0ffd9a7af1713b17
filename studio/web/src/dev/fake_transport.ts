// SPDX-License-Identifier: GPL-3.0-or-later
// A StudioService in the page's memory.
import { clone, create, fromJson } from "@bufbuild/protobuf";
import { createRouterTransport, Code, ConnectError, type Transport } from "@connectrpc/connect";
import { JobEventKind, JobEventSchema, JobState } from "../gen/flair/v1/job_pb";
import { ObjectKind, ObjectRole, ObjectSchema } from "../gen/flair/v1/object_list_pb";
import { ArtifactSchema } from "../gen/flair/v1/artifact_pb";
import {
  DocumentSchema,
  StudioService,
  WatchDocumentsResponseSchema,
  type WatchDocumentsResponse,
} from "../gen/flair/v1/studio_service_pb";
import { act } from "./fake_acts";
import { drawing, symbol } from "./fake_drawing";
import { judge } from "./fake_judge";
import { bedroomLayout, emptyLayout, FakeRoom } from "./fake_room";

const pause = (milliseconds: number) => new Promise((done) => setTimeout(done, milliseconds));

const stages = [
  ["room", "bedroom, 4 m x 5 m: 1 door, 2 windows, 3 sockets"], ["zones", "3 zones: sleeping, storage, work"],
  ["objects", "18 objects: 3 primary, 4 secondary, 11 tertiary"], ["style", "natural"], ["constraints", "42 sentences"],
  ["cleaning", "42 sentences, nothing to clean"], ["translation", "42 constraints of 42 sentences"],
  ["solve", "17 objects placed; 41 of 42 constraints hold"], ["render", "1600 x 1131 px, 193 kB"],
] as const;

const furniture: Array<[string, string, string, number, number, number]> = [
  ["armchair", "chair", "seating", 0.8, 0.8, 0.9], ["dining chair", "chair", "seating", 0.45, 0.5, 0.9],
  ["sofa", "sofa", "seating", 2.0, 0.9, 0.85], ["bookshelf", "bookshelf", "storage", 0.9, 0.3, 1.9],
  ["chest of drawers", "dresser", "storage", 1.0, 0.5, 0.8], ["coffee table", "table", "tables", 1.1, 0.6, 0.45],
  ["desk", "desk", "tables", 1.2, 0.6, 0.74], ["single bed", "bed", "beds", 0.9, 2.0, 0.5],
  ["gran's chair", "armchair", "own models", 0.7, 0.75, 1.0], ["floor lamp", "floor_lamp", "lighting", 0.4, 0.4, 1.6], ["plant", "plant", "decoration", 0.4, 0.4, 1.1],
];

export function fakeTransport(): Transport {
  const rooms = new Map<string, FakeRoom>();
  const bin = new Map<string, FakeRoom>();
  const listeners = new Set<(event: WatchDocumentsResponse["event"]) => void>();
  const tell = (event: WatchDocumentsResponse["event"]) => listeners.forEach((listener) => listener(event));
  const told = (room: FakeRoom) => tell({ case: "document", value: clone(DocumentSchema, room.document) });
  const roomOf = (id: string) => {
    const room = rooms.get(id);
    if (!room) throw new ConnectError(`no document is called "${id}"`, Code.NotFound);
    return room;
  };
  const add = (room: FakeRoom) => rooms.set(room.document.id, room).get(room.document.id)!;
  add(new FakeRoom("A bedroom that is 4m x 5m.", bedroomLayout()));
  add(new FakeRoom("A bedroom for a vampire, 14ft by 12ft.", bedroomLayout()));

  async function design(room: FakeRoom): Promise<void> {
    const jobId = (room.document.jobId = `job-${room.document.id}`);
    room.document.jobState = JobState.RUNNING;
    let sequence = 0n;
    const event = (kind: JobEventKind, stage: string, message = "", seconds = 0) => tell({ case: "jobEvent",
      value: create(JobEventSchema, { jobId, sequence: ++sequence, kind, stage, message, state: JobState.RUNNING,
        duration: { seconds: 0n, nanos: Math.round(seconds * 1e9) } }) });
    for (const [stage, message] of stages) {
      event(JobEventKind.STAGE_STARTED, stage);
      await pause(stage === "solve" ? 420 : 70);
      event(JobEventKind.STAGE_FINISHED, stage, message, stage === "solve" ? 0.42 : 0.03);
    }
    room.document.jobState = JobState.SUCCEEDED;
    room.put("design the room", bedroomLayout());
    told(room);
  }

  return createRouterTransport(({ service }) => {
    service(StudioService, {
      listDocuments: () => ({
        documents: [...rooms.values()].reverse().map((room) => clone(DocumentSchema, room.document)),
      }),
      createDocument: ({ source }) => {
        if (source.case === "documentId") {
          const { document, layout } = roomOf(source.value);
          return { document: clone(DocumentSchema, add(new FakeRoom(`Copy of ${document.title}`, layout!)).document) };
        }
        if (source.case === "file") {
          const { content } = fromJson(ArtifactSchema, JSON.parse(new TextDecoder().decode(source.value)), {
            ignoreUnknownFields: true,
          });
          if (content.case !== "solvedLayout")
            throw new ConnectError("The file holds neither a layout nor a room.", Code.InvalidArgument);
          return { document: clone(DocumentSchema, add(new FakeRoom("An opened room", content.value)).document) };
        }
        if (source.case === "room")
          return {
            document: clone(
              DocumentSchema,
              add(new FakeRoom(source.value.title || "My room", emptyLayout(source.value))).document,
            ),
          };
        const room = add(new FakeRoom(source.case === "design" ? (source.value.brief?.text ?? "") : "A room"));
        void pause(50).then(() => design(room));
        room.document.jobState = JobState.RUNNING;
        room.document.jobId = `job-${room.document.id}`;
        return { document: clone(DocumentSchema, room.document) };
      },
      getDocument: ({ documentId }) => {
        const room = roomOf(documentId);
        return { document: clone(DocumentSchema, room.document), layout: room.layout && room.copy() };
      },
      deleteDocument: ({ documentId }) => {
        bin.set(documentId, roomOf(documentId));
        rooms.delete(documentId);
        tell({ case: "deletedDocumentId", value: documentId });
        return {};
      },
      restoreDocument: ({ documentId }) => {
        const room = bin.get(documentId);
        if (room) add(room);
        bin.delete(documentId);
        return { document: clone(DocumentSchema, roomOf(documentId).document) };
      },
      act: async (request) => {
        const room = roomOf(request.documentId);
        if (request.revision !== room.document.revision)
          throw new ConnectError("The document has changed.", Code.Aborted);
        await pause(request.act.case === "settle" ? 60 : 15);
        const diagnostics = act(room, request);
        told(room);
        return { document: clone(DocumentSchema, room.document), layout: room.copy(), diagnostics };
      },
      judge: async ({ documentId, placements }) => {
        const layout = roomOf(documentId).copy();
        for (const at of placements)
          Object.assign(layout.placements.find((one) => one.objectId === at.objectId) ?? {}, at);
        await pause(12);
        return { ...judge(layout, placements.map((one) => one.objectId)), reachableFloorShare: 1 };
      },
      explain: ({ documentId }) => ({
        revision: roomOf(documentId).document.revision,
        note: roomOf(documentId).note(),
        notAsAsked: roomOf(documentId).document.title.includes("vampire")
          ? ["A coffin was asked for and is not known; nothing stands for it."]
          : [],
      }),
      drawDocument: ({ documentId }) => ({
        revision: roomOf(documentId).document.revision, parts: drawing(roomOf(documentId).copy()),
      }),
      exportDocument: async () => {
        // Put there by whoever wants to see it: flair export scene LAYOUT --out DIR/scene.glb
        const answer = await fetch("/scene.glb");
        if (!answer.ok) throw new ConnectError("There is no scene.glb beside the page.", Code.Unimplemented);
        const content = new Uint8Array(await answer.arrayBuffer());
        return { fileName: "bedroom.glb", mediaType: "model/gltf-binary", content };
      },
      shareDocument: ({ documentId }) => ({ jobId: `job-${roomOf(documentId).document.id}` }),
      listFurniture: ({ query }) => ({
        offers: furniture
          .filter(([name, , group]) => `${name} ${group}`.includes(query.toLowerCase()))
          .map(([name, category, group, widthM, depthM, heightM]) => {
            const object = create(ObjectSchema, {
              name,
              category,
              widthM,
              depthM,
              heightM,
              kind: ObjectKind.FLOOR,
              role: ObjectRole.SECONDARY,
            });
            return { object, group, svg: symbol(object) };
          }),
      }),
      async *watchDocuments(_request, context) {
        const waiting: Array<WatchDocumentsResponse["event"]> = [];
        let wake = () => {};
        const listener = (event: WatchDocumentsResponse["event"]) => { waiting.push(event); wake(); };
        listeners.add(listener);
        try {
          while (!context.signal.aborted) {
            while (waiting.length) yield create(WatchDocumentsResponseSchema, { event: waiting.shift() });
            await new Promise<void>((done) => { wake = done; });
          }
        } finally {
          listeners.delete(listener);
        }
      },
    });
  });
}
