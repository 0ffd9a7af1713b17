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

}  // namespace flair::language
