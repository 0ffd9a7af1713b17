// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "orchestrator/batch/work_queue.h"
#include "spdlog/logger.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/metrics/metrics.h"

namespace flair::orchestrator {

// Counts and logs what is done on a queue: jobs made, runs, stages, ends. Each log line carries the job's id.
std::unique_ptr<WorkQueue> MakeMeteredWorkQueue(std::unique_ptr<WorkQueue> inner, runtime::Metrics& metrics,
                                                const runtime::Clock& clock, std::shared_ptr<spdlog::logger> logger);

}  // namespace flair::orchestrator
