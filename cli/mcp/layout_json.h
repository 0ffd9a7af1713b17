// SPDX-License-Identifier: GPL-3.0-or-later
// Rooms as the tools return them; tools.json has the schemas.
#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "cli/mcp/message.h"
#include "flair/v1/studio_service.pb.h"

namespace flair::cli::mcp {

// A piece and where it stands; `placement` may be null.
Json PlaceJson(const v1::LayoutGraph& graph, const v1::Object& object, const v1::Placement* placement);
// "described", but for not_as_asked.
Json DescribedJson(const v1::Document& document, const v1::SolvedLayout& layout);
Json MeasuresJson(const google::protobuf::RepeatedPtrField<v1::EdgeOutcome>& outcomes,
                  const v1::LayoutMetrics& metrics);
// `graph` has the sentences that are not met.
Json FaultsJson(const v1::LayoutGraph& graph, const v1::LayoutMetrics& metrics);
// undo and redo, where there are any.
void AddHistory(const v1::Document& document, Json& json);

// The place of an object; null when it has none.
const v1::Placement* PlacementOf(const v1::SolvedLayout& layout, const std::string& id);

// The object that a caller means by its id or by a name that only it has. INVALID_ARGUMENT lists the ids.
absl::StatusOr<const v1::Object*> ObjectMeant(const v1::LayoutGraph& graph, const std::string& key,
                                              const std::string& field);

}  // namespace flair::cli::mcp
