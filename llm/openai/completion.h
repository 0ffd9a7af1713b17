// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "llm/client/chat.h"

namespace flair::llm {

// A completion as it is put together: at once from a "message", or bit by bit from "delta"s.
class Completion {
 public:
  // Takes in one object of the protocol, a whole completion or a chunk of a stream; what it does not have is left as it
  // was. DATA_LOSS when it is no object.
  absl::Status Add(const nlohmann::json& object);

  // Adds to the text of the answer, or to what the model thought, when there was a choice before; else false.
  bool AddText(std::string_view text, bool thought);

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

// The error inside a reply of status 200, or inside a stream; null when there is none, or one that says nothing.
const nlohmann::json* ErrorInside(const nlohmann::json& object);

}  // namespace flair::llm
