// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "llm/client/chat.h"
#include "llm/openai/completion.h"
#include "llm/openai/plain_delta.h"
#include "llm/openai/server_error.h"
#include "llm/openai/sse_reader.h"

namespace flair::llm {

// Reads a reply of status 2xx, streamed or not, as it comes. Of a stream it keeps the texts, 16 MiB at most: what wraps
// a token is fifty times as long. Errors: DATA_LOSS when it is not of the protocol (HTML, empty, not JSON, no choices)
// or too long; UNAVAILABLE when a stream ends early; that of an error inside the reply.
class ReplyReader {
 public:
  // `address` begins every error. All are borrowed.
  ReplyReader(const std::string& address, const ChatRequest& request, const Confidential& confidential)
      : address_(address), request_(request), confidential_(confidential) {}

  // Takes a piece of a streamed reply; an error ends the reading with it.
  absl::Status Take(std::string_view piece);

  // The answer of a stream that has ended. `model`: see Completion::ToAnswer.
  absl::StatusOr<ChatAnswer> FinishStream(const std::string& model);

  // The answer of a reply that came at once.
  absl::StatusOr<ChatAnswer> Read(std::string_view body, const std::string& model);

  // Whether the model thought before it answered.
  bool thought() const { return completion_.thought(); }

 private:
  absl::Status TakePiece(std::string_view piece);
  absl::Status TakeEvent(std::string_view data);
  absl::Status Add(std::string_view json_text);
  // Adds a chunk that brings a piece of text and nothing else; false, without a change, when it is none.
  bool AddPlainDelta(std::string_view json_text);
  absl::StatusOr<ChatAnswer> ToAnswer(const std::string& model) const;
  absl::Status NotOfTheProtocol(std::string_view what) const;

  const std::string& address_;
  const ChatRequest& request_;
  const Confidential& confidential_;
  SseReader sse_;
  Completion completion_;
  RepeatedDelta repeated_;
  bool done_ = false;
  // A server that knows no streams sends the whole reply at once; kept until its end.
  enum class Kind { kUnknown, kEvents, kWhole } kind_ = Kind::kUnknown;
  std::string whole_;
};

}  // namespace flair::llm
