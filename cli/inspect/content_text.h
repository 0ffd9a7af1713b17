// SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of content as a readable summary: what cli/output/message_view.h makes of it, with what belongs together
// side by side.
#pragma once

#include <string>

#include "flair/v1/artifact.pb.h"
#include "flair/v1/optimizer_service.pb.h"

namespace flair::cli {

// Rows of a table before it says how many more there are.
inline constexpr size_t kMostRows = 100;

std::string RoomText(const v1::Room& room, size_t most_rows = kMostRows);
// Equal pieces share a row that counts them.
std::string ObjectsText(const v1::ObjectList& list, size_t most_rows = kMostRows);
// Sentences, after what cleaning did to `raw`: with the words before and after where `raw` is known.
std::string CleanedText(const v1::ConstraintList& list, const v1::ConstraintList* raw, size_t most_rows = kMostRows);
// Sentences with their calls.
std::string GraphText(const v1::LayoutGraph& graph, size_t most_rows = kMostRows);
// Objects with their poses and verdicts, what costs most, what was dropped and why, and measures.
std::string LayoutText(const v1::SolvedLayout& layout, size_t most_rows = kMostRows);

// What is in the artifact. `raw` is the list before cleaning of a cleaned one; null where it is not known.
std::string ContentText(const v1::Artifact& artifact, const v1::ConstraintList* raw, size_t most_rows = kMostRows);

// What a solve did and found: measures, terms, what does not hold and why, and each stage with its time.
std::string SolveStats(const v1::SolveResponse& response);

}  // namespace flair::cli
