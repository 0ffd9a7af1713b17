// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/constraint_catalog.pb.h"
#include "translator_worker/grammar/call.h"
#include "translator_worker/model/argument_reader.h"
#include "translator_worker/model/call_text.h"

namespace flair::translator {

// A written call as one of the type: arguments by name or place. One without a name goes to the next parameter that can
// take it, past optional ones that cannot ("against_wall(bed, north)"), or to the list before it. Numbers are clamped
// to their range and the type's needs checked; `remarks` gets what was changed. INVALID_ARGUMENT says what does not fit
// and what would.
absl::StatusOr<Call> BindCall(const WrittenCall& written, const v1::ConstraintType& type, const ArgumentReader& reader,
                              std::vector<std::string>& remarks);

}  // namespace flair::translator
