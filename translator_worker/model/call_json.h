// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "translator_worker/model/call_text.h"

namespace flair::translator {

// Calls that a model wrote as JSON after all, in any of the usual forms: {"function": "near", "arguments": {...}},
// arguments as a list of names with values, of texts, or of values alone, {"near": {...}}, {"function": "near",
// "object": ...}; one, or a list of them. INVALID_ARGUMENT when it is no JSON or names no function. Pure; any text is
// good input.
absl::StatusOr<WrittenCalls> ReadCallJson(std::string_view text);

// One argument in the notation: "sofa", "target=sofa", "objects: [a, b]".
WrittenArgument ReadArgumentText(std::string_view text);

}  // namespace flair::translator
