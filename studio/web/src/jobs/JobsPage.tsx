// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs, batches, and who works on them. The address says which: "", "batches", "workers" or a batch's id.
import { goTo } from "../state/route";
import { BatchList } from "./BatchList";
import { BatchPage } from "./BatchPage";
import { ClusterPage } from "./ClusterPage";
import { JobList } from "./JobList";

const tabs = [
  ["", "Jobs"],
  ["batches", "Batches"],
  ["workers", "Workers"],
] as const;

export default function JobsPage({ id }: { id: string }) {
  const isBatch = !tabs.some(([one]) => one === id);
  return (
    <main class="stage is-jobs">
      <div class="jobs">
        <header class="jobs-head">
          <h1>Jobs</h1>
          <div class="segmented is-named" role="group" aria-label="What is listed">
            {tabs.map(([one, label]) => (
              <button
                key={one}
                aria-pressed={one === id || (isBatch && one === "batches")}
                onClick={() => goTo({ page: "jobs", id: one })}
              >
                {label}
              </button>
            ))}
          </div>
        </header>
        {id === "" && <JobList />}
        {id === "batches" && <BatchList />}
        {id === "workers" && <ClusterPage />}
        {isBatch && <BatchPage key={id} id={id} />}
      </div>
    </main>
  );
}
