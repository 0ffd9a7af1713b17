// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "flair/v1/constraint_list.pb.h"

namespace flair::language {

// Step D iii over any list, a model's as well: sentences that say two things about openings are split, fillers are cut,
// those that say the same of the same objects become one, and of two that contradict each other the weightier (else the
// earlier) stays. Every change is a step with its reason. Ids are never reused: changed sentences get ids of their own.
v1::ConstraintList CleanConstraints(const v1::ConstraintList& raw);

}  // namespace flair::language
