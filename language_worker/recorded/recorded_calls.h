// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "flair/model/v1/calls_answers.pb.h"
#include "language_worker/recorded/recorded_room.h"

namespace flair::language {

// Gives the calls that the recorded model translated its sentences to back to the sentences of a translation prompt. A
// recording does not say which call is of which sentence: a call goes to the sentence about its objects whose words
// name what the function does, the feature and the distance best; calls without such a sentence are kept in the
// remarks. `step` names the pass ("translation.inter"). Every sentence gets an entry.
model::v1::CallsAnswer FindCalls(const RecordedRoom& room, std::string_view step, std::string_view prompt,
                                 Conversion& conversion);

}  // namespace flair::language
