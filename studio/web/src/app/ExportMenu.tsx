// SPDX-License-Identifier: GPL-3.0-or-later
import { DocumentFormat } from "../gen/flair/v1/studio_service_pb";
import type { OpenRoom } from "../state/open_room";
import { useStudio, type Studio } from "../state/studio";
import { save } from "./files";
import { Icon } from "./Icon";
import { Menu } from "./Menu";

const formats: Array<{ format: DocumentFormat; label: string; hint: string } | "line"> = [
  { format: DocumentFormat.PLAN_PDF, label: "Plan for print", hint: "PDF" },
  { format: DocumentFormat.PLAN_PNG, label: "Plan as picture", hint: "PNG" },
  { format: DocumentFormat.PLAN_SVG, label: "Plan for drawing programs", hint: "SVG" },
  "line",
  { format: DocumentFormat.BIRDSEYE_PNG, label: "View from above, ray-traced", hint: "PNG" },
  { format: DocumentFormat.PERSPECTIVE_PNG, label: "View from within, ray-traced", hint: "PNG" },
  { format: DocumentFormat.SCENE_GLB, label: "Scene in three dimensions", hint: "GLB" },
  "line",
  { format: DocumentFormat.REPORT, label: "Report with reasons", hint: "MD" },
  { format: DocumentFormat.LAYOUT_JSON, label: "Layout, to open again", hint: "JSON" },
  { format: DocumentFormat.LAYOUT_PB, label: "Layout, to open again", hint: "PB" },
];

async function exportAs(studio: Studio, room: OpenRoom, format: DocumentFormat): Promise<void> {
  const isSlow = format === DocumentFormat.BIRDSEYE_PNG || format === DocumentFormat.PERSPECTIVE_PNG;
  if (isSlow) studio.toasts.note("The view is being traced; that takes some seconds.");
  const file = await studio.told(() => studio.clients.studio.exportDocument({ documentId: room.id, format }));
  if (file) save(file.fileName, file.mediaType, file.content);
}

export function ExportMenu({ room }: { room: OpenRoom }) {
  const studio = useStudio();
  const items = formats.map((one) => (one === "line" ? one
    : { label: one.label, hint: one.hint, run: () => void exportAs(studio, room, one.format) }));
  return <Menu label="Export" class="button" items={items}><Icon name="export" />Export</Menu>;
}
