// SPDX-License-Identifier: GPL-3.0-or-later
import { DocumentFormat } from "../gen/flair/v1/studio_service_pb";
import type { OpenRoom } from "../state/open_room";
import { goTo } from "../state/route";
import { useStudio, type Studio } from "../state/studio";
import { save } from "./files";
import { Icon } from "./Icon";
import { Menu } from "./Menu";

const formats: Array<{ format: DocumentFormat; label: string; hint: string } | "line"> = [
  { format: DocumentFormat.PLAN_PDF, label: "Plan for print", hint: "PDF" },
  { format: DocumentFormat.PLAN_PNG, label: "Plan as picture", hint: "PNG" },
  { format: DocumentFormat.PLAN_SVG, label: "Plan for drawing programs", hint: "SVG" },
  "line",
  { format: DocumentFormat.BIRDSEYE_PNG, label: "Bird's-eye, ray-traced", hint: "PNG" },
  { format: DocumentFormat.PERSPECTIVE_PNG, label: "Eye level, ray-traced", hint: "PNG" },
  { format: DocumentFormat.SCENE_GLB, label: "Scene in three dimensions", hint: "GLB" },
  "line",
  { format: DocumentFormat.REPORT, label: "Report with reasons", hint: "MD" },
  { format: DocumentFormat.LAYOUT_JSON, label: "Layout, to open again", hint: "JSON" },
  { format: DocumentFormat.LAYOUT_PB, label: "Layout, to open again", hint: "PB" },
  { format: DocumentFormat.ARTIFACTS_TAR, label: "All artifacts, from the brief on", hint: "TAR" },
];

// A sheet of A3 can be printed from its pixels.
const kPrinted_dpi = 200;

async function exportAs(studio: Studio, room: OpenRoom, format: DocumentFormat): Promise<void> {
  const isSlow = format === DocumentFormat.BIRDSEYE_PNG || format === DocumentFormat.PERSPECTIVE_PNG;
  if (isSlow) studio.toasts.note("The view is being traced; that takes some seconds.");
  const options = format === DocumentFormat.PLAN_PNG ? { dpi: kPrinted_dpi } : undefined;
  const file = await studio.told(() => studio.clients.studio.exportDocument({ documentId: room.id, format, options }));
  if (file) save(file.fileName, file.mediaType, file.content);
}

// Among the jobs it is drawn, listed and opened by whoever uses the same orchestrator.
async function share(studio: Studio, room: OpenRoom): Promise<void> {
  const shared = await studio.told(() => studio.clients.studio.shareDocument({ documentId: room.id }));
  if (!shared) return;
  studio.toasts.offer(`Saved with the orchestrator as job ${shared.jobId}.`,
    [{ label: "Show jobs", run: () => goTo({ page: "jobs" }) }]);
}

export function ExportMenu({ room }: { room: OpenRoom }) {
  const studio = useStudio();
  const files = formats.map((one) => (one === "line" ? one
    : { label: one.label, hint: one.hint, run: () => void exportAs(studio, room, one.format) }));
  const items = [...files, "line" as const,
    { label: "Save with the orchestrator", hint: "JOB", run: () => void share(studio, room) }];
  return <Menu label="Export" class="button" items={items}><Icon name="export" />Export</Menu>;
}
