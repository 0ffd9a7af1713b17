// SPDX-License-Identifier: GPL-3.0-or-later
// A request with its answer as JSON text, as it is kept in files.
#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "llm/client/chat.h"

namespace flair::llm {

// What decides the answer: messages, schema, limit, seed when it is not 0; not the step. Equal requests give equal texts. Bytes that are not
// UTF-8 become U+FFFD.
std::string RequestJson(const ChatRequest& request);

// Both, indented for people.
std::string RecordJson(const ChatRequest& request, const ChatAnswer& answer);

// The answer of a record. DATA_LOSS, naming the field, for anything else.
absl::StatusOr<ChatAnswer> ReadRecordJson(const std::string& text);

}  // namespace flair::llm
