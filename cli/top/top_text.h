// SPDX-License-Identifier: GPL-3.0-or-later
// A cluster as text.
#pragma once

#include <string>
#include <vector>

#include "cli/top/cluster_state.h"

namespace flair::cli {

struct TopLayout {
  int width = 80;
  // Lines; what does not fit is counted. Any number when 0.
  int height = 0;
  // With ANSI colours.
  bool color = false;
};

// Lines of at most `width` characters: totals, batches, orchestrators, workers. `address` is who was asked; `trouble`,
// when not empty, says why what is shown is old. Nothing in it steers a terminal but our own colours.
std::vector<std::string> TopText(const ClusterState& state, const std::string& address, const std::string& trouble,
                                 const TopLayout& layout);

// "12 s", "5m12s", "2h05m", "3d04h".
std::string ShortDuration(absl::Duration duration);

// "12,345".
std::string Grouped(int64_t number);

// The state as one JSON object on one line, without line break.
std::string TopJson(const ClusterState& state);

}  // namespace flair::cli
