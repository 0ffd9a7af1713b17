// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "english/frames/facts.h"
#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/translator_service.pb.h"

namespace flair::translator {

// The facts that the sentence's typed meaning states, their objects by index of the request's list; none when it has no
// meaning, or one of another text. An error says what of the meaning cannot be used: a relation that no frame knows, or
// knows only with other participants, or something that is not in the room.
absl::StatusOr<std::vector<english::Fact>> TypedFacts(const v1::TranslateRequest& request,
                                                      const v1::Sentence& sentence);

}  // namespace flair::translator
