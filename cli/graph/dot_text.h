// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/graph/layout_diagram.h"

namespace flair::cli {

// The diagram in Graphviz's language: zones are clusters in the plan's colours, objects tables with a row for each call
// about them alone, links coloured by verdict with the sentences as tooltips. Pure; any text of a layout is escaped.
std::string DotText(const Diagram& diagram);

}  // namespace flair::cli
