-- SPDX-License-Identifier: GPL-3.0-or-later
-- Version 1 of the job store. Times are microseconds since 1970 UTC. Messages are serialized protobufs of flair.v1.
-- States and kinds are the numbers of their enums. Artifacts themselves are not here; see local_artifacts.h.

-- One row per job. Ids sort by age.
CREATE TABLE jobs (
  id TEXT PRIMARY KEY,
  request_id TEXT UNIQUE,                    -- NULL for jobs of a batch
  spec BLOB NOT NULL,                        -- JobSpec
  state INTEGER NOT NULL,                    -- JobState
  stage TEXT NOT NULL DEFAULT '',
  error TEXT NOT NULL DEFAULT '',
  error_code INTEGER NOT NULL DEFAULT 0,
  create_time_us INTEGER NOT NULL,
  end_time_us INTEGER NOT NULL DEFAULT 0,
  batch_id TEXT NOT NULL DEFAULT '',
  owner TEXT NOT NULL DEFAULT '',            -- the process that runs it; see owner_lock.h
  cancel_requested INTEGER NOT NULL DEFAULT 0
) WITHOUT ROWID;
CREATE INDEX jobs_open ON jobs (state, id) WHERE state IN (1, 2);
CREATE INDEX jobs_by_batch ON jobs (batch_id, id) WHERE batch_id != '';

-- What happened to each job, in order.
CREATE TABLE events (
  job_id TEXT NOT NULL,
  sequence INTEGER NOT NULL,
  event BLOB NOT NULL,                       -- JobEvent
  PRIMARY KEY (job_id, sequence)
) WITHOUT ROWID;

-- The artifacts of each job, at most one per stage.
CREATE TABLE job_artifacts (
  job_id TEXT NOT NULL,
  stage_index INTEGER NOT NULL,
  artifact_id TEXT NOT NULL,
  kind INTEGER NOT NULL,                     -- ArtifactKind
  size_bytes INTEGER NOT NULL,
  PRIMARY KEY (job_id, stage_index)
) WITHOUT ROWID;

-- What a stage made of given inputs: the index for re-use.
CREATE TABLE results (
  key TEXT PRIMARY KEY,                      -- see result_key.h
  artifact_id TEXT NOT NULL,
  kind INTEGER NOT NULL,
  size_bytes INTEGER NOT NULL
) WITHOUT ROWID;

CREATE TABLE batches (
  id TEXT PRIMARY KEY,
  request_id TEXT NOT NULL UNIQUE,
  specs_digest TEXT NOT NULL                 -- tells a repeat from another batch under the same request_id
) WITHOUT ROWID;
