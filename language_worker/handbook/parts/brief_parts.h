// SPDX-License-Identifier: GPL-3.0-or-later
// What a brief brings by itself (objects, constraints), together with what the handbook has for the rest. Used where
// the handbook answers and where a model does.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/brief.pb.h"
#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "flair/v1/zone_plan.pb.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/brief_facts.h"

namespace flair::language {

// Adds a remark.
template <typename WithDiagnostics>
void AddDiagnostic(v1::Severity severity, std::string code, std::string message, WithDiagnostics& to) {
  v1::Diagnostic& diagnostic = *to.add_diagnostics();
  diagnostic.set_severity(severity);
  diagnostic.set_code(std::move(code));
  diagnostic.set_message(std::move(message));
}

// The words of a name in lower case, one space between them, without other signs.
std::string PlainName(std::string_view name);

// Compares what a brief asks for with what is listed: whatever was lost between the two, and was not left out with its
// reason, becomes a remark.
void TellNotAsAsked(const BriefFacts& facts, const Handbook& handbook, v1::ObjectList& list);

// Ids of the zones that the brief's own objects are in, in the order of the objects.
std::vector<std::string> WantedZones(const v1::Brief& brief);

// Adds those that the plan lacks, with a remark.
void AddWantedZones(const v1::Brief& brief, v1::ZonePlan& plan);

// The handbook's zones with those of the brief's own objects.
absl::StatusOr<v1::ZonePlan> PlanWantedZones(const v1::Brief& brief, const v1::Room& room, const Handbook& handbook);

// What the steps about objects are given.
struct ObjectsRequest {
  const v1::Brief& brief;
  const v1::Room& room;
  const v1::ZonePlan& zones;
};

// Adds a sentence with the next id, unless it is empty or the list is full. A subject named twice counts once.
void AddSentence(const std::string& text, v1::SentenceScope scope, double weight,
                 const std::vector<std::string>& subjects, v1::ConstraintList& list);
void AddSentence(const v1::Sentence& sentence, v1::ConstraintList& list);

// Adds the sentences that say where the tertiaries go: as their lister placed them, else as in `usual`.
void AddPlacements(const v1::ObjectList& objects, const v1::ConstraintList& usual, v1::ConstraintList& list);

// The handbook's sentences, with the placements of the tertiaries that their lister placed in the stead of its own.
absl::StatusOr<v1::ConstraintList> UsualConstraints(const ObjectsRequest& request, const v1::ObjectList& objects,
                                                    const Handbook& handbook);

// The brief's own constraints, and placements of the tertiaries that these do not mention; of the brief's own objects
// only those that it places.
absl::StatusOr<v1::ConstraintList> OwnConstraints(const ObjectsRequest& request, const v1::ObjectList& objects,
                                                  const Handbook& handbook);

}  // namespace flair::language
