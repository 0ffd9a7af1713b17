// SPDX-License-Identifier: GPL-3.0-or-later
// Calls as short text, for the examples in facts and for tests: "object=bed side=back", "center=table objects=a,b,c",
// "object=sofa distance_m=0.5 parallel=false".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "flair/v1/constraint_catalog.pb.h"
#include "flair/v1/layout_graph.pb.h"

namespace flair::optimizer {

// Arguments typed as the type's parameters say; an unknown name becomes a text, so that the checks can report it.
std::vector<v1::Argument> ArgumentsFromText(const v1::ConstraintType& type, std::string_view call);

// An edge of that type with those arguments and weight 1. The type may be an alias; of one that only another optimizer
// knows, the arguments are what they look like: a number, true or false, several names with commas between, or a name.
v1::ConstraintEdge EdgeFromText(std::string_view type, std::string_view call);

}  // namespace flair::optimizer
