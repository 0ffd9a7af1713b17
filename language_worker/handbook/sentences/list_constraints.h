// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/brief.pb.h"
#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "flair/v1/zone_plan.pb.h"
#include "language_worker/handbook/handbook.h"

namespace flair::language {

// Step D i and ii, and where tertiaries go: the sentences that the handbook has for these objects in this room. Objects
// that the handbook does not know get the general rules that fit. Errors as ReadBrief.
absl::StatusOr<v1::ConstraintList> ListConstraints(const v1::Brief& brief, const v1::Room& room,
                                                   const v1::ZonePlan& zones, const v1::ObjectList& objects,
                                                   const Handbook& handbook);

// A sentence that says how one uses a piece.
struct UseSentence {
  v1::Sentence sentence;
  // Words by which other sentences about the piece alone give way to it.
  std::vector<std::string> overrules;
};

// How these objects are used, whoever listed them: those of ListConstraints whose relations are uses. `objects` go by
// the names of their classes, `spoken` has the same by the names that sentences call them by. Without ids, in the order
// of the objects; a topic that the brief settles has none. Errors as ReadBrief.
absl::StatusOr<std::vector<UseSentence>> ListUses(const v1::Brief& brief, const v1::Room& room,
                                                  const v1::ZonePlan& zones, const v1::ObjectList& objects,
                                                  const v1::ObjectList& spoken, const Handbook& handbook);

}  // namespace flair::language
