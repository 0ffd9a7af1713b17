// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "flair/v1/layout_graph.pb.h"

namespace flair::cli {

// A call as it is written: "against_wall(object=bed, side=back)", with " x 3" when it weighs 3.
std::string CallText(const v1::ConstraintEdge& edge);

}  // namespace flair::cli
