// SPDX-License-Identifier: GPL-3.0-or-later
// What a job has stored, as files.
import { toJson } from "@bufbuild/protobuf";
import { ArtifactKind, ArtifactSchema, type Artifact, type ArtifactRef } from "../gen/flair/v1/artifact_pb";
import { PreviewFormat, PreviewView } from "../gen/flair/v1/preview_pb";
import { save } from "../app/files";
import type { Studio } from "../state/studio";

const kKinds: Partial<Record<ArtifactKind, string>> = {
  [ArtifactKind.RAW_CONSTRAINT_LIST]: "wishes, as written",
  [ArtifactKind.CONSTRAINT_LIST]: "wishes, checked",
  [ArtifactKind.COMPLETED_CONSTRAINT_LIST]: "wishes, completed",
  [ArtifactKind.SOLVED_LAYOUT]: "layout",
  [ArtifactKind.LAYOUT_GRAPH]: "problem",
  [ArtifactKind.OBJECT_LIST]: "furniture",
  [ArtifactKind.STYLE_SHEET]: "style",
  [ArtifactKind.PREVIEW]: "picture",
};

// "brief", "layout", "wishes, checked".
export const fileText = ({ kind }: ArtifactRef): string =>
  kKinds[kind] ?? (ArtifactKind[kind] ?? "artifact").toLowerCase().replace(/_/g, " ");

export const sizeText = (bytes: bigint): string =>
  bytes < 1000n ? `${bytes} B` : bytes < 1000_000n ? `${bytes / 1000n} kB` : `${(Number(bytes) / 1e6).toFixed(1)} MB`;

function contentOf(artifact: Artifact, ref: ArtifactRef): { name: string; type: string; bytes: Uint8Array } {
  if (artifact.content.case === "preview") {
    const { view, format, image } = artifact.content.value;
    const ending = (PreviewFormat[format] ?? "bin").toLowerCase();
    return { name: `${(PreviewView[view] ?? "view").toLowerCase()}.${ending}`, type: `image/${ending}`, bytes: image };
  }
  const json = `${JSON.stringify(toJson(ArtifactSchema, artifact), null, 1)}\n`;
  const name = `${fileText(ref).replace(/[^a-z]+/g, "-")}.json`;
  return { name, type: "application/json", bytes: new TextEncoder().encode(json) };
}

export async function saveFile(studio: Studio, ref: ArtifactRef): Promise<void> {
  const answer = await studio.told(() => studio.clients.orchestrator.getArtifact({ artifactId: ref.id }));
  if (!answer?.artifact) return;
  const { name, type, bytes } = contentOf(answer.artifact, ref);
  save(name, type, bytes);
}
