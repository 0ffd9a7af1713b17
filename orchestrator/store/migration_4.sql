-- SPDX-License-Identifier: GPL-3.0-or-later
-- Version 4 of the job store kept ids and keys as bytes behind a digest of the job's brief. Version 5 reads its tables,
-- whichever of the two forms the ids have, so a store of version 3 gets the columns only.
CREATE TABLE new_job_artifacts (
  job_id TEXT NOT NULL,
  stage_index INTEGER NOT NULL,
  artifact_id BLOB NOT NULL,
  kind INTEGER NOT NULL,
  size_bytes INTEGER NOT NULL,
  brief BLOB NOT NULL,
  caller TEXT NOT NULL,
  PRIMARY KEY (job_id, stage_index)
) WITHOUT ROWID;
INSERT INTO new_job_artifacts SELECT job_id, stage_index, artifact_id, kind, size_bytes, x'', '' FROM job_artifacts;

CREATE TABLE new_results (
  brief BLOB NOT NULL,
  key BLOB NOT NULL,
  artifact_id BLOB NOT NULL,
  kind INTEGER NOT NULL,
  size_bytes INTEGER NOT NULL,
  PRIMARY KEY (brief, key)
) WITHOUT ROWID;
INSERT INTO new_results SELECT x'', key, artifact_id, kind, size_bytes FROM results;

DROP TABLE job_artifacts;
DROP TABLE results;
ALTER TABLE new_job_artifacts RENAME TO job_artifacts;
ALTER TABLE new_results RENAME TO results;
ALTER TABLE deleted_artifacts ADD COLUMN brief BLOB NOT NULL DEFAULT x'';
