// SPDX-License-Identifier: GPL-3.0-or-later
// What may happen to the record of a job, as pure functions; who stores the result by compare-and-set decides.
#pragma once

#include <span>
#include <string>

#include "absl/time/time.h"
#include "flair/store/v1/job_record.pb.h"
#include "orchestrator/batch/lease.h"

namespace flair::orchestrator {

bool HasEnded(const store::v1::JobRecord& record);

// A job that waits for its first run.
store::v1::JobRecord NewRecord(const v1::Job& job, const std::string& request_id);

// A run begins; whoever ran it before is out.
void BeginRun(store::v1::JobRecord& record, const std::string& holder);

// Stages of the run did something.
void AddStageRecords(store::v1::JobRecord& record, std::span<const StageRecord> stages);

// The one moment at which the job ends, with what its stages did last.
void EndJob(store::v1::JobRecord& record, const JobEnd& end);

// The run ends, the job does not. Remembered as an event when there is a reason.
void ReturnJob(store::v1::JobRecord& record, absl::Time not_before, const std::string& reason);

// A failed job waits again.
void RetryJob(store::v1::JobRecord& record);

// The end of a job that somebody wanted to end.
JobEnd CancelledEnd(absl::Time time);

}  // namespace flair::orchestrator
