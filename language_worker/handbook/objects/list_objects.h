// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/brief.pb.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "flair/v1/zone_plan.pb.h"
#include "language_worker/handbook/handbook.h"

namespace flair::language {

// Step C i to iii: primaries in zone order, secondaries, tertiaries with their hosts; what does not fit is named in
// `omissions`. Errors as ReadBrief.
absl::StatusOr<v1::ObjectList> ListObjects(const v1::Brief& brief, const v1::Room& room, const v1::ZonePlan& zones,
                                           const Handbook& handbook);

// Tells before all else which essentials of the brief's kind of room are missing in a list that came from elsewhere.
// Errors as ReadBrief.
absl::Status TellMissing(const v1::Brief& brief, const v1::Room& room, const Handbook& handbook, v1::ObjectList& list);

// Steps C i and ii alone.
absl::StatusOr<v1::ObjectList> ListFloorObjects(const v1::Brief& brief, const v1::Room& room, const v1::ZonePlan& zones,
                                                const Handbook& handbook);

// Step C iii alone: the tertiaries that complete objects which came from elsewhere and bear the names of the handbook's
// classes where they are of one. Nothing of a class that is among their tertiaries already. Ids are unique among the
// tertiaries only.
absl::StatusOr<v1::ObjectList> ListTertiaries(const v1::Brief& brief, const v1::Room& room, const v1::ZonePlan& zones,
                                              const v1::ObjectList& objects, const Handbook& handbook);

}  // namespace flair::language
