// SPDX-License-Identifier: GPL-3.0-or-later
// How a message is checked: every field by its rule (rules.textproto), messages inside it likewise, then what several
// fields say together by the Check of its type. Callers outside this folder use validate.h.
#pragma once

#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"
#include "flair/v1/language_service.pb.h"
#include "flair/v1/optimizer_service.pb.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "flair/v1/renderer_service.pb.h"
#include "flair/v1/translator_service.pb.h"
#include "room/validation/field.h"

namespace flair::validation {

// Of points in a room or beside it, metres.
inline constexpr Range kCoordinate{.least = -1000, .most = 1000};

// What the parts of one problem may refer to. Sets that are null are not known, and references to them not followed.
struct Known {
  const NameSet* zones = nullptr;
  const NameSet* objects = nullptr;
  const NameSet* openings = nullptr;
  const NameSet* sentences = nullptr;
  const NameSet* edges = nullptr;
};

// Reports all that is wrong with a message of package flair.v1. Its parts may refer to each other and to `known`.
void CheckMessage(const google::protobuf::Message& message, const Known& known, const Field& at);

// What several fields of one message say together, or one alone that no rule can say. Fields that break a rule have
// been reported already.
void Check(const v1::Brief& brief, const Known& known, const Field& at);
void Check(const v1::Room& room, const Known& known, const Field& at);
void Check(const v1::Object& object, const Known& known, const Field& at);
void Check(const v1::ObjectList& list, const Known& known, const Field& at);
void Check(const v1::StyleSheet& sheet, const Known& known, const Field& at);
void Check(const v1::ParameterSpec& parameter, const Known& known, const Field& at);
void Check(const v1::ConstraintType& type, const Known& known, const Field& at);
void Check(const v1::ConstraintCatalog& catalog, const Known& known, const Field& at);
void Check(const v1::Participant& participant, const Known& known, const Field& at);
void Check(const v1::Measure& measure, const Known& known, const Field& at);
void Check(const v1::ConstraintEdge& edge, const Known& known, const Field& at);
void Check(const v1::LayoutGraph& graph, const Known& known, const Field& at);
void Check(const v1::ZoneRegion& region, const Known& known, const Field& at);
void Check(const v1::SolvedLayout& layout, const Known& known, const Field& at);
void Check(const v1::Preview& preview, const Known& known, const Field& at);
void Check(const v1::Report& report, const Known& known, const Field& at);
void Check(const v1::Artifact& artifact, const Known& known, const Field& at);
void Check(const v1::SolveOptions& options, const Known& known, const Field& at);
void Check(const v1::RenderOptions& options, const Known& known, const Field& at);
void Check(const v1::ViewCamera& camera, const Known& known, const Field& at);
void Check(const v1::ContactSheetOptions& options, const Known& known, const Field& at);
void Check(const v1::ContactSheetTile& tile, const Known& known, const Field& at);
void Check(const v1::SolveRestartsRequest& request, const Known& known, const Field& at);
void Check(const v1::RenderRequest& request, const Known& known, const Field& at);
void Check(const v1::CreateBatchRequest& request, const Known& known, const Field& at);

// The ids of a list's elements, for looking up references.
template <typename List>
NameSet IdsOf(const List& list) {
  NameSet ids;
  for (const auto& element : list) ids.insert(element.id());
  return ids;
}

}  // namespace flair::validation
