// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/config/v1/llm_config.pb.h"
#include "llm/client/llm_client.h"
#include "llm/http/http_request.h"
#include "llm/openai/server_error.h"

namespace flair::llm {

inline constexpr int kUsualOutputTokenCount = 4096;
// Thoughts take several times as many tokens as an answer, and the limit is of both.
inline constexpr int kThinkersOutputTokenCount = 16384;

// How one model is reached and asked.
struct OpenAiOptions {
  config::v1::LlmConfig config;     // as CheckLlmConfig wants it
  std::string api_key;              // secret; empty when the server wants none
  std::vector<HttpHeader> headers;  // the user's own, sent with every request; the values may be secrets

  // The first form of answers to try, and whether weaker ones follow when the server rejects it.
  config::v1::AnswerForm first_form() const {
    return falls_back() ? config::v1::ANSWER_FORM_JSON_SCHEMA : config.answer_form();
  }
  bool falls_back() const { return config.answer_form() == config::v1::ANSWER_FORM_UNSPECIFIED; }
};

// Where requests go, OpenAI's address or Azure's.
std::string CompletionsUrl(const OpenAiOptions& options);

// With the key in the header that the server looks for.
std::vector<HttpHeader> RequestHeaders(const OpenAiOptions& options);

// The key and the values of the user's own headers.
std::vector<std::string> SecretsOf(const OpenAiOptions& options);

// What decides the answers, in a line; nothing secret.
std::string IdentityOf(const OpenAiOptions& options);

// Which fields of a request one server takes. Begins as the options want it and only ever becomes weaker, so that
// asking again ends.
struct Dialect {
  config::v1::AnswerForm form = config::v1::ANSWER_FORM_JSON_SCHEMA;
  // Limits of numbers and of the lengths of lists in schemas.
  bool schema_limits = true;
  // The schema in the prompt as well: the server takes response_format and does not keep to it.
  bool schema_in_prompt = false;
  // A limit of the answer's length; by max_completion_tokens instead of max_tokens, which is what most servers take.
  bool token_limit = true;
  bool completion_token_limit = false;
  // The model thinks before it answers, and the limit counts its thoughts.
  bool thinks = false;
  bool temperature = true;
  bool seed = true;
  bool stream = true;
  // stream_options, to be told the usage.
  bool stream_usage = true;
  // Messages of role "system"; otherwise their text goes before the first question.
  bool system_role = true;

  bool operator==(const Dialect&) const = default;
};

// What to try after the server rejected a request made in `dialect`; none when another form of it would not help.
// `with_schema`: the request has a schema. What answers show, `schema_in_prompt` and `thinks`, stays as it is.
std::optional<Dialect> WeakerDialect(const Dialect& dialect, const OpenAiOptions& options, bool with_schema,
                                     int http_status, const ServerError& error);

// Whether the server rejects the schema itself, not the form: then other schemas may still be sent.
bool RejectsSchema(const ServerError& error);

// The JSON of a chat completion request, its fields always in the same order. A schema that is not asked for by
// response_format goes into the system's message. INVALID_ARGUMENT when the request's schema is no JSON object.
absl::StatusOr<std::string> EncodeRequest(const OpenAiOptions& options, const Dialect& dialect,
                                          const ChatRequest& request);

}  // namespace flair::llm
