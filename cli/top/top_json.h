// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/top/cluster_state.h"

namespace flair::cli {

// The same as TopText as one JSON object on one line, without line break: time, totals, batches, orchestrators,
// workers.
std::string TopJson(const ClusterState& state);

}  // namespace flair::cli
