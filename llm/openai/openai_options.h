// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "llm/http/http_request.h"

namespace flair::llm {

// How answers are asked for; see AnswerForm in llm_config.proto.
enum class AnswerForm { kJsonSchema, kJsonObject, kText };

inline constexpr int kUsualOutputTokenCount = 4096;
// Thoughts take several times as many tokens as an answer, and the limit is of both.
inline constexpr int kThinkersOutputTokenCount = 16384;

// Azure OpenAI: where the model is.
struct AzureDeployment {
  // Name of the deployment, such as "room-designer".
  std::string name;
  // Such as "2024-10-21".
  std::string api_version;
};

// How one model is reached and asked; checked by whoever read it from a configuration.
struct OpenAiOptions {
  // Up to and without "/chat/completions", such as "https://api.openai.com/v1"; with Azure without "/openai".
  std::string base_url;
  // As the server calls it; with Azure only a name.
  std::string model;
  // Secret. Empty when the server wants none.
  std::string api_key;
  std::optional<AzureDeployment> azure;
  // Sent with every request; the values may be secrets.
  std::vector<HttpHeader> headers;
  // [0, 2]; the server's default when unset.
  std::optional<double> temperature;
  // Sent instead of those of the requests.
  std::optional<int64_t> seed;
  // For requests that set no limit of their own; 0 means kUsualOutputTokenCount, or kThinkersOutputTokenCount for a
  // model that thinks before it answers.
  int max_output_token_count = 0;
  // The first form to try. With `fall_back`, weaker ones follow when the server rejects it.
  AnswerForm answer_form = AnswerForm::kJsonSchema;
  bool fall_back = true;
  bool stream = false;
};

// Where requests go, OpenAI's address or Azure's.
std::string CompletionsUrl(const OpenAiOptions& options);

// With the key in the header that the server looks for.
std::vector<HttpHeader> RequestHeaders(const OpenAiOptions& options);

// The key and the values of the user's own headers.
std::vector<std::string> SecretsOf(const OpenAiOptions& options);

// What decides the answers, in a line; nothing secret.
std::string IdentityOf(const OpenAiOptions& options);

}  // namespace flair::llm
