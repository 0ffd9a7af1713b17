// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "absl/status/statusor.h"
#include "cli/input/service_flags.h"
#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "flair/v1/zone_plan.pb.h"

namespace flair::cli {

// What the handbook says of these objects in this room, uses marked; models of one's own are what their names end with.
// The handbook is read when it is first asked: errors as language::LoadHandbook. Thread-safe.
using DesignerSentences =
    std::function<absl::StatusOr<v1::ConstraintList>(const v1::Room&, const v1::ZonePlan&, const v1::ObjectList&)>;
DesignerSentences SentencesOfHandbook(const StageChoice& stages);

}  // namespace flair::cli
