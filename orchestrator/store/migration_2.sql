-- SPDX-License-Identifier: GPL-3.0-or-later
-- Version 2 of the job store: batches that grow, pause and are watched; attempts, kinds of failure, callers.
ALTER TABLE jobs ADD COLUMN batch_index INTEGER NOT NULL DEFAULT 0;    -- place in the batch, from 0
ALTER TABLE jobs ADD COLUMN failure_kind INTEGER NOT NULL DEFAULT 0;   -- FailureKind
ALTER TABLE jobs ADD COLUMN attempt_count INTEGER NOT NULL DEFAULT 0;  -- runs begun; with `owner`, who may write
ALTER TABLE jobs ADD COLUMN caller TEXT NOT NULL DEFAULT '';           -- Job.owner: who asked for it
ALTER TABLE jobs ADD COLUMN not_before_us INTEGER NOT NULL DEFAULT 0;  -- waits at least until then

ALTER TABLE batches ADD COLUMN job_count INTEGER NOT NULL DEFAULT 0;
ALTER TABLE batches ADD COLUMN state INTEGER NOT NULL DEFAULT 1;       -- BatchState
ALTER TABLE batches ADD COLUMN open INTEGER NOT NULL DEFAULT 0;
ALTER TABLE batches ADD COLUMN label TEXT NOT NULL DEFAULT '';
ALTER TABLE batches ADD COLUMN create_time_us INTEGER NOT NULL DEFAULT 0;
ALTER TABLE batches ADD COLUMN caller TEXT NOT NULL DEFAULT '';

UPDATE jobs SET batch_index = places.place FROM
  (SELECT id, row_number() OVER (PARTITION BY batch_id ORDER BY id) - 1 AS place FROM jobs WHERE batch_id != '') AS places
  WHERE jobs.id = places.id;
UPDATE batches SET job_count = (SELECT count(*) FROM jobs WHERE jobs.batch_id != '' AND jobs.batch_id = batches.id);

DROP INDEX jobs_open;
DROP INDEX jobs_by_batch;
CREATE INDEX jobs_waiting ON jobs (batch_id, id) WHERE state = 1;
CREATE INDEX jobs_running ON jobs (owner) WHERE state = 2;
CREATE INDEX jobs_by_batch ON jobs (batch_id, state, failure_kind, id) WHERE batch_id != '';
CREATE INDEX jobs_delayed ON jobs (not_before_us) WHERE state = 1 AND not_before_us > 0;
CREATE INDEX jobs_by_caller ON jobs (caller, id) WHERE caller != '';
CREATE INDEX jobs_open_by_caller ON jobs (caller) WHERE state IN (1, 2) AND caller != '';
CREATE INDEX jobs_by_artifact ON job_artifacts (artifact_id);
CREATE INDEX batches_active ON batches (id) WHERE state = 1;

-- The jobs of batches in the order in which they ended; a job that ends again moves to the end.
CREATE TABLE ends (
  sequence INTEGER PRIMARY KEY AUTOINCREMENT,
  batch_id TEXT NOT NULL,
  job_id TEXT NOT NULL UNIQUE
);
CREATE INDEX ends_by_batch ON ends (batch_id, sequence);
INSERT INTO ends (batch_id, job_id) SELECT batch_id, id FROM jobs WHERE batch_id != '' AND state > 2 ORDER BY end_time_us, id;

-- What the orchestrators say of themselves.
CREATE TABLE orchestrators (
  id TEXT PRIMARY KEY,
  status BLOB NOT NULL,                      -- OrchestratorStatus
  report_time_us INTEGER NOT NULL
) WITHOUT ROWID;
