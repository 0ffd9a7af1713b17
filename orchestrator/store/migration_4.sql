-- SPDX-License-Identifier: GPL-3.0-or-later
-- Version 4 of the job store: what jobs with one brief have lies together. Digests lie anywhere; with the brief's before
-- them all keys of a job are on a page or two, not on one each. See BriefDigest and docs/decisions. flair_digest() makes
-- bytes of a digest's hex, flair_brief() a BriefDigest of a JobSpec; see digest_functions.h.

-- The artifacts of each job, at most one per stage.
CREATE TABLE new_job_artifacts (
  job_id TEXT NOT NULL,
  stage_index INTEGER NOT NULL,
  artifact_id BLOB NOT NULL,
  kind INTEGER NOT NULL,                     -- ArtifactKind
  size_bytes INTEGER NOT NULL,
  brief BLOB NOT NULL,                       -- of the job
  caller TEXT NOT NULL,                      -- of the job
  PRIMARY KEY (job_id, stage_index)
) WITHOUT ROWID;
INSERT INTO new_job_artifacts
  SELECT job_id, stage_index, flair_digest(artifact_id), kind, size_bytes, flair_brief(spec), caller
  FROM job_artifacts JOIN jobs ON jobs.id = job_id;

-- What a stage made of given inputs, which begin with a brief: the index for re-use.
CREATE TABLE new_results (
  brief BLOB NOT NULL,
  key BLOB NOT NULL,                         -- see ResultKey
  artifact_id BLOB NOT NULL,
  kind INTEGER NOT NULL,
  size_bytes INTEGER NOT NULL,
  PRIMARY KEY (brief, key)
) WITHOUT ROWID;
INSERT OR REPLACE INTO new_results
  SELECT flair_brief(spec), flair_digest(key), flair_digest(results.artifact_id), results.kind, results.size_bytes
  FROM results JOIN job_artifacts ON job_artifacts.artifact_id = results.artifact_id JOIN jobs ON jobs.id = job_id
  ORDER BY 1, 2;                             -- written once each, not page by page at random

DROP TABLE job_artifacts;
DROP TABLE results;
ALTER TABLE new_job_artifacts RENAME TO job_artifacts;
ALTER TABLE new_results RENAME TO results;
CREATE INDEX jobs_by_artifact ON job_artifacts (brief, artifact_id);
CREATE INDEX results_by_artifact ON results (brief, artifact_id);
CREATE INDEX artifacts_of_callers ON job_artifacts (artifact_id, caller) WHERE caller != '';

-- Nobody has what waits already, under whatever brief.
ALTER TABLE deleted_artifacts ADD COLUMN brief BLOB NOT NULL DEFAULT x'';  -- of the jobs that had it
