// SPDX-License-Identifier: GPL-3.0-or-later
import { PaperSize } from "../gen/flair/v1/renderer_service_pb";
import { DocumentFormat } from "../gen/flair/v1/studio_service_pb";
import type { OpenRoom } from "../state/open_room";
import { goTo } from "../state/route";
import type { Paper } from "../state/settings";
import { useStudio, type Studio } from "../state/studio";
import { save } from "./files";
import { Icon } from "./Icon";
import { Menu } from "./Menu";

interface Export {
  readonly format: DocumentFormat;
  readonly label: string;
  readonly hint: string;
  // Whether it is a sheet of paper.
  readonly isSheet?: boolean;
  // What is said of it while it takes its time.
  readonly slow?: string;
}

const kTraced = "The picture is made; that takes some seconds.";
const kPacked = "Plans, views, model and lists are made; that takes some seconds.";

const formats: Array<Export | "line" | "paper"> = [
  { format: DocumentFormat.PLAN_PDF, label: "Plan to print", hint: "PDF", isSheet: true },
  { format: DocumentFormat.PLAN_PNG, label: "Plan as a picture", hint: "PNG", isSheet: true },
  { format: DocumentFormat.PLAN_SVG, label: "Plan for drawing programs", hint: "SVG", isSheet: true },
  "paper",
  "line",
  { format: DocumentFormat.BIRDSEYE_PNG, label: "View from above", hint: "PNG", slow: kTraced },
  { format: DocumentFormat.PERSPECTIVE_PNG, label: "View at eye level", hint: "PNG", slow: kTraced },
  { format: DocumentFormat.SCENE_GLB, label: "Model for 3D programs", hint: "GLB" },
  "line",
  { format: DocumentFormat.FURNITURE_CSV, label: "List of furniture, for spreadsheets", hint: "CSV" },
  { format: DocumentFormat.REPORT, label: "Report: every piece and why", hint: "MD" },
  { format: DocumentFormat.LAYOUT_JSON, label: "This room, to open again", hint: "JSON" },
  "line",
  { format: DocumentFormat.EVERYTHING_ZIP, label: "Everything in one archive", hint: "ZIP", isSheet: true, slow: kPacked },
];

// A sheet can be printed from its pixels.
const kPrinted_dpi = 200;
const papers: Record<Paper, PaperSize> = { A4: PaperSize.A4, A3: PaperSize.A3 };

async function exportAs(studio: Studio, room: OpenRoom, { format, isSheet, slow }: Export): Promise<void> {
  if (slow) studio.toasts.note(slow);
  const paper = papers[studio.settings.paper.peek()], dpi = format === DocumentFormat.PLAN_PNG ? kPrinted_dpi : undefined;
  const options = isSheet ? { paper, dpi } : undefined;
  const file = await studio.told(() => studio.clients.studio.exportDocument({ documentId: room.id, format, options }));
  if (!file) return;
  save(file.fileName, file.mediaType, file.content);
  studio.toasts.note(`Saved ${file.fileName}.`);
}

// Among the jobs it is drawn, listed and opened by whoever uses the same server.
async function share(studio: Studio, room: OpenRoom): Promise<void> {
  const shared = await studio.told(() => studio.clients.studio.shareDocument({ documentId: room.id }));
  if (!shared) return;
  studio.toasts.offer("Put among the jobs, where everybody who uses this server finds it.",
    [{ label: "Show it", run: () => goTo({ page: "jobs" }) }]);
}

export function ExportMenu({ room }: { room: OpenRoom }) {
  const studio = useStudio();
  const paper = { label: "Paper", values: Object.keys(papers) as Paper[], setting: studio.settings.paper };
  const files = formats.map((one) => (one === "line" ? one : one === "paper" ? paper
    : { label: one.label, hint: one.hint, run: () => void exportAs(studio, room, one) }));
  const items = [...files, { label: "Put it among the jobs", run: () => void share(studio, room) }];
  return <Menu label="Export" class="button" items={items}><Icon name="export" />Export</Menu>;
}
