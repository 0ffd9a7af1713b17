// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/status.h"
#include "flair/v1/layout_graph.pb.h"

namespace flair::cli {

// Completes a graph that comes without its language stage, such as a recorded one: adds the sentences that follow from
// the use of its objects, with their calls, and takes out the calls that they overrule. A call without a sentence
// counts as one of the words of its type. Errors of the handbook's files.
absl::Status CompleteGraph(v1::LayoutGraph& graph);

}  // namespace flair::cli
