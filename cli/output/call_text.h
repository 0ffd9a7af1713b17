// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "flair/v1/layout_graph.pb.h"

namespace flair::cli {

// "bed", "[left, right]", "0.6" or "true"; "?" when unset.
std::string ValueText(const v1::ArgumentValue& value);

// A call as it is written: "against_wall(object=bed, side=back)".
std::string CallText(const std::string& type, const google::protobuf::RepeatedPtrField<v1::Argument>& arguments);

// The same, with " x 3" when it weighs 3.
std::string CallText(const v1::ConstraintEdge& edge);

}  // namespace flair::cli
