-- SPDX-License-Identifier: GPL-3.0-or-later
-- Version 5 of the job store: ids and keys are text again, and nothing is kept by the digest of a brief.

-- The artifacts of each job, at most one per stage.
CREATE TABLE plain_job_artifacts (
  job_id TEXT NOT NULL,
  stage_index INTEGER NOT NULL,
  artifact_id TEXT NOT NULL,
  kind INTEGER NOT NULL,                     -- ArtifactKind
  size_bytes INTEGER NOT NULL,
  PRIMARY KEY (job_id, stage_index)
) WITHOUT ROWID;
INSERT INTO plain_job_artifacts
  SELECT job_id, stage_index, iif(length(artifact_id) = 32, lower(hex(artifact_id)), CAST(artifact_id AS TEXT)), kind,
    size_bytes
  FROM job_artifacts;

-- What a stage made of given inputs: the index for re-use.
CREATE TABLE plain_results (
  key TEXT PRIMARY KEY,                      -- see ResultKey
  artifact_id TEXT NOT NULL,
  kind INTEGER NOT NULL,
  size_bytes INTEGER NOT NULL
) WITHOUT ROWID;
INSERT OR REPLACE INTO plain_results
  SELECT iif(length(key) = 32, lower(hex(key)), CAST(key AS TEXT)),
    iif(length(artifact_id) = 32, lower(hex(artifact_id)), CAST(artifact_id AS TEXT)), kind, size_bytes
  FROM results ORDER BY 1;

DROP TABLE job_artifacts;
DROP TABLE results;
ALTER TABLE plain_job_artifacts RENAME TO job_artifacts;
ALTER TABLE plain_results RENAME TO results;
CREATE INDEX jobs_by_artifact ON job_artifacts (artifact_id);
CREATE INDEX results_by_artifact ON results (artifact_id);
ALTER TABLE deleted_artifacts DROP COLUMN brief;
