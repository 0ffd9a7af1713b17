// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "flair/v1/layout_graph.pb.h"

namespace flair::optimizer {

using IdSet = std::set<std::string, std::less<>>;

// Takes objects out of a graph with all that refers to them: edges that name them (one that lists several objects only
// loses the name), pins, hosts, sentences' subjects and styles. Returns a diagnostic per edge changed or taken out.
std::vector<v1::Diagnostic> RemoveObjects(const IdSet& ids, v1::LayoutGraph& graph);

}  // namespace flair::optimizer
