// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "flair/v1/constraint_catalog.pb.h"
#include "optimizer_worker/constraints/facts.h"

namespace flair::optimizer {

// The layouts of a type's facts as messages that Evaluate takes as they are. What the short texts leave out is filled
// in: a zone for what belongs to none, a usual height, and a small object that keeps a zone's mean point where the text
// has it.
google::protobuf::RepeatedPtrField<v1::PlacedExample> PlacedExamplesOf(const ConstraintFacts& facts);

}  // namespace flair::optimizer
