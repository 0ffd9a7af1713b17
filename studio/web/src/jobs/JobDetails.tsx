// SPDX-License-Identifier: GPL-3.0-or-later
// What a job was asked for and what came of it, with its plan and its files.
import { timestampDate } from "@bufbuild/protobuf/wkt";
import { measureWords, capital, percent, withStop } from "../inspector/words";
import type { Job } from "../gen/flair/v1/job_pb";
import { useStudio } from "../state/studio";
import type { Facts } from "./facts";
import { fileText, saveFile, sizeText } from "./job_files";
import type { JobPictures } from "./pictures";
import { tookText } from "./words";

function Lines({ title, lines, isBad }: { title: string; lines: readonly string[]; isBad?: boolean }) {
  if (lines.length === 0) return null;
  return (
    <section>
      <h3 class="eyebrow">{title}</h3>
      <ul class={isBad ? "notices" : "lines"}>
        {lines.map((line) => <li key={line} class={isBad ? "notice is-warning" : ""}>{withStop(capital(line))}</li>)}
      </ul>
    </section>
  );
}

export function JobDetails({ job, facts, pictures }: { job: Job; facts: Facts | undefined; pictures: JobPictures }) {
  const studio = useStudio();
  const plan = pictures.planOf(job).value;
  const { held, uses, floor } = pictures.measuresOf(job).value ?? {};
  const measures = [[measureWords.wishes, held], [measureWords.uses, uses], [measureWords.floor, floor]] as const;
  const known = measures.flatMap(([{ label }, share]) => (share === undefined ? [] : [`${label} ${percent(share)}`]));
  const began = job.createTime && timestampDate(job.createTime).toLocaleString();
  return (
    <div class="job-details">
      {plan && <img class="job-plan" src={plan} alt="Plan of the room" />}
      <div class="job-facts">
        <section>
          <h3 class="eyebrow">Asked for</h3>
          <p>{job.spec?.brief?.text}</p>
          <p class="hint">
            {[began, tookText(job) && `took ${tookText(job)}`, job.owner && `by ${job.owner}`, `job ${job.id}`]
              .filter(Boolean).join(" · ")}
          </p>
        </section>
        {facts && <Lines title="Not as asked" lines={facts.notDone} isBad />}
        {facts && facts.count > 0 && (
          <section>
            <h3 class="eyebrow">In the room</h3>
            <p>{withStop(capital(facts.pieces.join(", ")))}</p>
            {known.length > 0 && <p class="hint">{known.join(" · ")}</p>}
          </section>
        )}
        {job.artifacts.length > 0 && (
          <section>
            <h3 class="eyebrow">Files</h3>
            <ul class="job-files">
              {job.artifacts.map((ref) => (
                <li key={`${ref.kind} ${ref.id}`}>
                  <button class="chip" title={`Save it (${sizeText(ref.sizeBytes)})`} onClick={() => void saveFile(studio, ref)}>
                    {capital(fileText(ref))}
                  </button>
                </li>
              ))}
            </ul>
          </section>
        )}
      </div>
    </div>
  );
}
