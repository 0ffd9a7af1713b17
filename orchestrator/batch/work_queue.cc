// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/batch/work_queue.h"

#include <fmt/format.h>

namespace flair::orchestrator {

std::string BatchJobId(const std::string& batch_id, int64_t index) { return fmt::format("{}-{:08}", batch_id, index); }

}  // namespace flair::orchestrator
