// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/object_list.pb.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/model/floor_objects_step.h"

namespace flair::language {

// Step D i and ii with a model, both asked at once, and the tertiaries' placements as sentences. Where the handbook
// may stand in and one of the two answers is of no use, its sentences take the place of that one's, with a remark.
// Errors as Conversation::Ask.
absl::StatusOr<v1::ConstraintList> AskConstraints(const ObjectsRequest& request, const v1::ObjectList& objects,
                                                  const ModelTools& tools, llm::Conversation& conversation);

// Adds a sentence with the next id, unless it is empty or the list is full.
void AddSentence(const std::string& text, v1::SentenceScope scope, double weight,
                 const std::vector<std::string>& subjects, v1::ConstraintList& list);

// Adds one that comes from another list.
void AddSentence(const v1::Sentence& sentence, v1::ConstraintList& list);

// Adds the sentences that say where the tertiaries go: as their lister placed them, else as in `usual`.
void AddPlacements(const v1::ObjectList& objects, const v1::ConstraintList& usual, v1::ConstraintList& list);

// The handbook's sentences, with the placements of the tertiaries that their lister placed in the stead of its own.
// Errors as ReadBrief.
absl::StatusOr<v1::ConstraintList> UsualConstraints(const ObjectsRequest& request, const v1::ObjectList& objects,
                                                    const Handbook& handbook);

// The brief's own constraints, and placements of the tertiaries that these do not mention; of the brief's own objects
// only those that it places. Errors as ReadBrief.
absl::StatusOr<v1::ConstraintList> OwnConstraints(const ObjectsRequest& request, const v1::ObjectList& objects,
                                                  const Handbook& handbook);

}  // namespace flair::language
