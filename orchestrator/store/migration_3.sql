-- SPDX-License-Identifier: GPL-3.0-or-later
-- Version 3 of the job store: what has ended can be deleted.
ALTER TABLE jobs ADD COLUMN deletions_seen INTEGER NOT NULL DEFAULT 0;  -- of deleted_artifacts, when the run began
ALTER TABLE jobs ADD COLUMN lost_run_count INTEGER NOT NULL DEFAULT 0;  -- runs in a row that ended without a word and stored nothing

CREATE INDEX results_by_artifact ON results (artifact_id);
CREATE INDEX jobs_ended_alone ON jobs (end_time_us, id) WHERE batch_id = '' AND state > 2;

-- Artifacts that no job has any more: `pending` ones are to be deleted, of others that has been done. Those are remembered
-- for as long as a run goes on that began before and may think that it has one; see deletion_table.h.
CREATE TABLE deleted_artifacts (
  sequence INTEGER PRIMARY KEY AUTOINCREMENT,
  artifact_id TEXT NOT NULL UNIQUE,
  pending INTEGER NOT NULL
);
