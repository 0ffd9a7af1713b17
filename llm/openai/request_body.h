// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "llm/client/chat.h"
#include "llm/openai/dialect.h"
#include "llm/openai/openai_options.h"

namespace flair::llm {

// The JSON of a chat completion request, its fields always in the same order. A schema that is not asked for by
// response_format goes into the system's message. INVALID_ARGUMENT when the request's schema is no JSON object.
absl::StatusOr<std::string> EncodeRequest(const OpenAiOptions& options, const Dialect& dialect,
                                          const ChatRequest& request);

}  // namespace flair::llm
