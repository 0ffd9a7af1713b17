// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace flair::language
