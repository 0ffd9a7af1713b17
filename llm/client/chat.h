// SPDX-License-Identifier: GPL-3.0-or-later
// One question to a language model and its answer, whatever speaks to the model.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace flair::llm {

enum class Role { kSystem, kUser, kAssistant };

struct Message {
  Role role = Role::kUser;
  // UTF-8.
  std::string text;
};

// What is asked. Everything in it but `step` decides the answer; sampling and the model's name are the client's.
struct ChatRequest {
  // What it is for, such as "zones" or "objects.floor/repair": names the call in records, logs and meters.
  std::string step;
  std::vector<Message> messages;
  // JSON schema that the answer must follow, as compact JSON text, and its name ([a-zA-Z0-9_-]{1,64}); both empty when
  // the answer is free text.
  std::string schema;
  std::string schema_name;
  // 0 means the client's own limit.
  int max_output_token_count = 0;
  // Chooses among equally good answers, as a brief's seed does; sent where the server can repeat an answer. A client
  // that is configured with a seed sends its own.
  int64_t seed = 0;
};

// Tokens of one call.
struct Usage {
  int64_t input_token_count = 0;
  int64_t output_token_count = 0;
  // Part of the input that the server had cached.
  int64_t cached_input_token_count = 0;
  // The server did not say; counted from the lengths of the texts.
  bool estimated = false;
};

enum class FinishReason { kStop, kLength, kRefused, kOther };

struct ChatAnswer {
  // As received; with a schema it should be JSON, but a model may write anything.
  std::string text;
  FinishReason finish = FinishReason::kStop;
  Usage usage;
  // As the server named it; the configured name when it did not.
  std::string model;
  // US dollars, by the configured prices; 0 where there is none.
  double cost_usd = 0;
};

// About as many tokens as the text has: a quarter of its bytes, rounded up.
int64_t EstimateTokens(const std::string& text);

// Of all that is sent with a question.
int64_t EstimateTokens(const ChatRequest& request);

}  // namespace flair::llm
