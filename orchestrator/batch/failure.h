// SPDX-License-Identifier: GPL-3.0-or-later
// What kind of failure ended a run, and whether another run may help.
#pragma once

#include <string_view>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "flair/v1/job.pb.h"

namespace flair::orchestrator {

// The same error, known to come from the orchestrator's own store and not from a worker.
absl::Status OfStore(absl::Status status);
bool IsOfStore(const absl::Status& status);

// The kind of a failure of a stage; see FailureKind. `stage` as in JobEvent.stage.
v1::FailureKind KindOfFailure(const absl::Status& failure, std::string_view stage);

// Whether the same run, made later, may succeed: a worker, a model or a store that was down or slow.
bool MayPass(const absl::Status& failure, v1::FailureKind kind);

// How long a job waits after its `failure_count`-th failed run: 1 s, 4 s, 16 s, at most a minute; spread by up to a
// half of itself by `key`, so that jobs that failed together do not come back together.
absl::Duration DelayAfterFailure(int failure_count, const std::string& key);

}  // namespace flair::orchestrator
