// SPDX-License-Identifier: GPL-3.0-or-later
// The checks of single messages, for composing; callers outside this folder use validate.h.
#pragma once

#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"
#include "flair/v1/language_service.pb.h"
#include "flair/v1/model_call.pb.h"
#include "flair/v1/optimizer_service.pb.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "flair/v1/renderer_service.pb.h"
#include "flair/v1/translator_service.pb.h"
#include "room/validation/field.h"

namespace flair::validation {

// Of points in a room or beside it, metres.
inline constexpr Range kCoordinate{.least = -1000, .most = 1000};

// Of seeds: up to 2^53, so that every one is exact in a double.
inline constexpr Range kSeed{.least = 0, .most = 9007199254740992.0, .open_most = true};

// What the parts of one problem may refer to. Sets that are null are not known, and references to them not followed.
struct Known {
  const NameSet* zones = nullptr;
  const NameSet* objects = nullptr;
  const NameSet* openings = nullptr;
  const NameSet* sentences = nullptr;
  const NameSet* edges = nullptr;
  const v1::Room* room = nullptr;
};

void Check(const v1::Brief& brief, const Field& at);
void Check(const v1::Room& room, const Field& at);
void Check(const v1::ZonePlan& plan, const Field& at);
void Check(const v1::ObjectList& list, const Known& known, const Field& at);
void Check(const v1::StyleSheet& sheet, const Known& known, const Field& at);
void Check(const v1::ConstraintList& list, const Known& known, const Field& at);
void Check(const v1::ConstraintCatalog& catalog, const Field& at);
void Check(const v1::LayoutGraph& graph, const Field& at);
void Check(const v1::SolvedLayout& layout, const Field& at);
void Check(const v1::SolveOptions& options, const Field& at);
void Check(const v1::RenderOptions& options, const Field& at);
void Check(const v1::ContactSheetOptions& options, const Field& at);
void Check(const v1::ContactSheetTile& tile, const Field& at);
void Check(const v1::ModelOptions& options, const Field& at);
void Check(const v1::JobSpec& spec, const Field& at);
void Check(const v1::Preview& preview, const Field& at);
void Check(const v1::Report& report, const Field& at);
void Check(const v1::Artifact& artifact, const Field& at);
void Check(const v1::Polygon& polygon, const Field& at);

void CheckPlacements(const google::protobuf::RepeatedPtrField<v1::Placement>& placements, const Known& known,
                     const Field& at);
void CheckDiagnostics(const google::protobuf::RepeatedPtrField<v1::Diagnostic>& diagnostics, const Field& at);
void CheckEdgeOutcomes(const google::protobuf::RepeatedPtrField<v1::EdgeOutcome>& outcomes, const Known& known,
                       const Field& at);

// Ids in the order-free form that references are looked up in.
NameSet ZoneIds(const v1::ZonePlan& plan);
NameSet ObjectIds(const v1::ObjectList& list);
NameSet OpeningIds(const v1::Room& room);
NameSet SentenceIds(const v1::ConstraintList& list);
NameSet EdgeIds(const v1::LayoutGraph& graph);

}  // namespace flair::validation
