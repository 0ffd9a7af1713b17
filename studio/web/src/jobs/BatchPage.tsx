// SPDX-License-Identifier: GPL-3.0-or-later
// A batch: how far it is, and its rooms as a page of plans to choose from by measure.
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { Icon } from "../app/Icon";
import { JobState, type Job } from "../gen/flair/v1/job_pb";
import { goTo } from "../state/route";
import { useStudio } from "../state/studio";
import { Asked } from "./Asked";
import { BatchBar, BatchButtons, BatchFailures, batchTitle, countsOf } from "./BatchHead";
import { StateFilter } from "./JobList";
import { JobTile } from "./JobTile";
import { anyMeasures, isFiltered, measureNames, passes, type Least, type MeasureName } from "./measures";
import { JobPictures } from "./pictures";
import { usePolling } from "./polling";
import { batchText } from "./words";
import { percent } from "../inspector/words";

const kPage = 60;

// Pages of the batch's jobs: the first as often as it is polled, the following when they are scrolled to.
function useJobs(batchId: string, state: JobState, endedCount: number) {
  const { clients } = useStudio();
  const [jobs, setJobs] = useState<readonly Job[]>([]),
    [token, setToken] = useState(""),
    [isAsked, setAsked] = useState(false);
  useEffect(() => {
    let isGone = false;
    void clients.orchestrator
      .listJobs({ batchId, state, pageSize: kPage })
      .then((page) => {
        if (isGone) return;
        setJobs((before) => [
          ...page.jobs,
          ...before.filter((job) => !page.jobs.some(({ id }) => id === job.id) && before.length > kPage),
        ]);
        setToken((before) => before || page.nextPageToken);
        setAsked(true);
      })
      .catch(() => setAsked(true));
    return () => {
      isGone = true;
    };
  }, [batchId, state, endedCount]);
  const more = async () => {
    if (!token) return;
    const page = await clients.orchestrator.listJobs({ batchId, state, pageSize: kPage, pageToken: token });
    setJobs((before) => [...before, ...page.jobs.filter((job) => !before.some(({ id }) => id === job.id))]);
    setToken(page.nextPageToken);
  };
  return { jobs, hasMore: token !== "", more, isAsked };
}

function MeasureFilters({ least, take }: { least: Least; take(least: Least): void }) {
  return (
    <div class="measure-filters">
      {(Object.keys(measureNames) as MeasureName[]).map((name) => (
        <label key={name} title={measureNames[name].title}>
          <span>{measureNames[name].label}</span>
          <input
            type="range"
            min={0}
            max={1}
            step={0.05}
            value={least[name]}
            aria-valuetext={least[name] > 0 ? `at least ${percent(least[name])}` : "any"}
            onInput={(event) => take({ ...least, [name]: Number(event.currentTarget.value) })}
          />
          <output>{least[name] > 0 ? `≥ ${percent(least[name])}` : "any"}</output>
        </label>
      ))}
    </div>
  );
}

function Results({ batchId, endedCount }: { batchId: string; endedCount: number }) {
  const studio = useStudio();
  const [state, setState] = useState<JobState>(JobState.SUCCEEDED),
    [least, setLeast] = useState<Least>(anyMeasures);
  const pictures = useMemo(() => new JobPictures(studio.clients), [studio]);
  useEffect(() => () => pictures.forgetAll(), [pictures]);
  const { jobs, hasMore, more, isAsked } = useJobs(batchId, state, endedCount);
  const end = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const observer = new IntersectionObserver(
      ([entry]) => {
        if (entry!.isIntersecting) void studio.told(more);
      },
      { rootMargin: "400px" },
    );
    observer.observe(end.current!);
    return () => observer.disconnect();
  }, [jobs, hasMore]);
  const isByMeasure = isFiltered(least);
  const shown = isByMeasure ? jobs.filter((job) => passes(pictures.measuresOf(job).value, least)) : jobs;
  return (
    <>
      <div class="results-head">
        <StateFilter state={state} take={setState} />
        <MeasureFilters least={least} take={setLeast} />
      </div>
      {isByMeasure && (
        <p class="hint results-count">
          {shown.length} of the {jobs.length} rooms looked at{hasMore ? "; more come as you scroll" : ""}.
        </p>
      )}
      {isAsked && jobs.length === 0 && <p class="jobs-empty">No job of the batch is in this state.</p>}
      <ul class="tiles">
        {shown.map((job) => (
          <JobTile key={job.id} job={job} pictures={pictures} />
        ))}
      </ul>
      <div ref={end} class="results-end">
        {hasMore && (
          <button class="button" onClick={() => void studio.told(more)}>
            Show more
          </button>
        )}
      </div>
    </>
  );
}

export function BatchPage({ id }: { id: string }) {
  const { clients } = useStudio();
  const asked = usePolling(id, async () => (await clients.orchestrator.getBatch({ batchId: id })).batch);
  const { value, again } = asked;
  return (
    <>
      <button class="link-button jobs-back" onClick={() => goTo({ page: "jobs", id: "batches" })}>
        All batches
      </button>
      <Asked of={asked} />
      {value && (
        <section class="batch is-open">
          <div class="batch-line">
            <h2 class="batch-title">
              <Icon name="queue" />
              {batchTitle(value)}
            </h2>
            <span class="batch-state">{batchText(value)}</span>
          </div>
          <BatchBar batch={value} />
          <div class="batch-line">
            <span class="batch-counts">{countsOf(value)}</span>
            <BatchButtons batch={value} changed={again} />
          </div>
          <BatchFailures batch={value} />
        </section>
      )}
      {value && <Results batchId={id} endedCount={value.jobCount - value.openCount} />}
    </>
  );
}
