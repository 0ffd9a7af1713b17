// SPDX-License-Identifier: GPL-3.0-or-later
// A job's room as a document.
import type { Job } from "../gen/flair/v1/job_pb";
import type { Document } from "../gen/flair/v1/studio_service_pb";
import { goTo } from "../state/route";
import type { Studio } from "../state/studio";

const shows = (job: Job, { layoutId }: Document): boolean => job.artifacts.some(({ id }) => id === layoutId);

// One that still shows what the job came to, or a new one.
export async function openResult(studio: Studio, job: Job): Promise<void> {
  const same = studio.documents.peek().find((document) => shows(job, document));
  if (same) return goTo({ page: "document", id: same.id });
  await studio.create({ case: "jobId", value: job.id });
}

// The document that the job was made for, where it shows something else by now.
export const editedRoomOf = (documents: readonly Document[], job: Job): Document | undefined =>
  documents.find((document) => document.jobId === job.id && document.layoutId && !shows(job, document));
