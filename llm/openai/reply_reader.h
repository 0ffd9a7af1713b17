// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "llm/client/chat.h"
#include "llm/openai/server_error.h"

namespace flair::llm {

// Reads server-sent events out of bytes that arrive in any pieces. Lines end in LF, CR LF or CR. Only the data of
// events is of interest here: their names, ids and comments are skipped.
class SseReader {
 public:
  // Takes the data of one event; an error ends the reading with it.
  using OnEvent = std::function<absl::Status(std::string_view data)>;

  absl::Status Take(std::string_view piece, const OnEvent& on_event);

  // At the end of the stream: an event that no empty line ended counts too.
  absl::Status Finish(const OnEvent& on_event);

  // Of the event that has not ended.
  size_t kept_byte_count() const { return line_.size() + data_.size(); }

 private:
  absl::Status TakeLine(std::string_view line, const OnEvent& on_event);

  std::string line_;
  std::string data_;
  bool has_data_ = false;
  // The last line ended in CR: a LF that follows belongs to it.
  bool after_cr_ = false;
  bool first_line_ = true;
};

// A completion as it is put together: at once from a "message", or bit by bit from "delta"s.
class Completion {
 public:
  // Takes in one object of the protocol, a whole completion or a chunk of a stream; what it does not have is left as it
  // was. DATA_LOSS when it is no object.
  absl::Status Add(const nlohmann::json& object);

  // Of all its texts.
  size_t text_byte_count() const {
    return content_.size() + refusal_.size() + thoughts_.size() + tool_arguments_.size();
  }

  // True when a choice said why it ended.
  bool finished() const { return !finish_.empty(); }

  // True when the model thought before it answered.
  bool thought() const {
    return thought_ || !thoughts_.empty() ||
           std::string_view(content_).substr(0, 20).find("<think") != std::string_view::npos;
  }

  // DATA_LOSS when there was no choice. `model` and the lengths of the texts stand in for what the server did not say.
  absl::StatusOr<ChatAnswer> ToAnswer(const ChatRequest& request, const std::string& model) const;

 private:
  void AddChoice(const nlohmann::json& choice);
  void AddUsage(const nlohmann::json& usage);

  bool has_choice_ = false;
  std::string content_;
  std::string refusal_;
  // What the model thought, where the server tells that apart.
  std::string thoughts_;
  // It spent tokens on that.
  bool thought_ = false;
  // Of the first tool called.
  std::string tool_arguments_;
  std::string finish_;
  std::string model_;
  std::optional<Usage> usage_;
};

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
  absl::StatusOr<ChatAnswer> ToAnswer(const std::string& model) const;
  absl::Status NotOfTheProtocol(std::string_view what) const;

  const std::string& address_;
  const ChatRequest& request_;
  const Confidential& confidential_;
  SseReader sse_;
  Completion completion_;
  bool done_ = false;
  // A server that knows no streams sends the whole reply at once; kept until its end.
  enum class Kind { kUnknown, kEvents, kWhole } kind_ = Kind::kUnknown;
  std::string whole_;
};

}  // namespace flair::llm
