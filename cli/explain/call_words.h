// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "flair/v1/layout_graph.pb.h"
#include "room/scene/scene.h"

namespace flair::cli {

// What a call asks of its subject, for calls that come from no sentence: "has its back flush on a wall". Begins with
// the verb, no full stop. A call that cannot be read gives "meets TYPE".
std::string CallInWords(const v1::ConstraintEdge& edge, const Scene& scene);

// Indices of the objects that a call places: its first object, or all of its group. Empty when it names none that the
// scene has.
std::vector<int> SubjectsOf(const v1::ConstraintEdge& edge, const Scene& scene);

// Indices of all objects that a call names, in its order.
std::vector<int> AllNamedIn(const v1::ConstraintEdge& edge, const Scene& scene);

// "a, b and c".
std::string Joined(const std::vector<std::string>& items);

}  // namespace flair::cli
