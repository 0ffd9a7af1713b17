// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "flair/v1/constraint_catalog.pb.h"
#include "flair/v1/layout_graph.pb.h"

namespace flair::contract {

using Arguments = google::protobuf::RepeatedPtrField<v1::Argument>;

// What is wrong with the arguments of a call of `type`: one that the type does not have, one that is missing, a value
// of another kind or out of range, an id that the graph does not have. Empty when nothing is. Without a graph ids are
// not looked up.
std::string ArgumentsFault(const v1::ConstraintType& type, const Arguments& arguments,
                           const v1::LayoutGraph* graph = nullptr);

// What is wrong with a parameter itself: no doc, a range or a unit without a number, a default of another kind.
std::string ParameterFault(const v1::ParameterSpec& parameter);

}  // namespace flair::contract
