// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/openai/openai_client.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "worker_runtime/status/status_macros.h"

namespace flair::llm {
namespace {

// Whether an answer is what a server writes that keeps to the schema: one JSON object with all that it requires.
bool KeepsTo(const std::string& schema_text, const std::string& answer_text) {
  const nlohmann::json schema = ParseJson(schema_text), answer = ParseJson(answer_text);
  const nlohmann::json* const required = Field(schema, "required");
  if (required == nullptr || !required->is_array()) return true;
  return answer.is_object() && std::ranges::all_of(*required, [&](const nlohmann::json& name) {
           return !name.is_string() || answer.contains(name.get_ref<const std::string&>());
         });
}

// What wraps a token of a stream is fifty times as long as the token.
HttpOptions ForStreams(HttpOptions http, bool stream) {
  constexpr int64_t kStreamByteLimit = 64 << 20;
  if (stream) http.body_byte_limit = kStreamByteLimit;
  return http;
}

}  // namespace

OpenAiClient::OpenAiClient(OpenAiOptions options, HttpOptions http, const runtime::Clock& clock)
    : options_(std::move(options)),
      http_(ForStreams(std::move(http), options_.config.stream()), clock),
      url_(CompletionsUrl(options_)),
      address_(PublicAddress(url_)),
      dialect_{.form = options_.first_form()} {}

absl::StatusOr<ChatAnswer> OpenAiClient::Ask(const ChatRequest& request, runtime::CallContext& call) {
  const Confidential confidential{SecretsOf(options_), request.messages};
  Attempt attempt{.dialect = Known(request.schema_name)};
  // Ends: each dialect is weaker than the one before.
  while (true) {
    HttpRequest sent{.url = url_, .headers = RequestHeaders(options_)};
    ASSIGN_OR_RETURN(sent.body, EncodeRequest(options_, attempt.dialect, request));
    ASSIGN_OR_RETURN(const HttpResponse response, http_.Send(sent, call));
    if (response.status / 100 == 2) {
      ASSIGN_OR_RETURN(const ChatReply reply, ReadReply(response.body, options_.config.stream(),
                                                        {address_, request, confidential, options_.config.model()}));
      attempt.thought = reply.thought;
      Learn(request, attempt, reply.answer);
      return reply.answer;
    }
    const ServerError error = ReadServerError(response.body);
    const std::optional<Dialect> weaker =
        WeakerDialect(attempt.dialect, options_, !request.schema.empty(), response.status, error);
    if (!weaker.has_value()) return Failure(response, error, confidential);
    attempt = {.dialect = *weaker,
               .dialect_is_new = true,
               .schema_rejected = weaker->form != attempt.dialect.form && RejectsSchema(error)};
  }
}

absl::StatusOr<ChatAnswer> OpenAiClient::Failure(const HttpResponse& response, const ServerError& error,
                                                 const Confidential& confidential) const {
  if (response.status / 100 == 4 && IsRefusal(error)) {
    return ChatAnswer{.text = "", .finish = FinishReason::kRefused, .usage = {}, .model = options_.config.model()};
  }
  std::string where = fmt::format("{}: HTTP {}", address_, response.status);
  if (response.status == 404 && error.message.empty()) where += ", no such address; most base addresses end in /v1";
  absl::Status status = StatusOf(response.status, error, std::move(where), confidential);
  AddRetryAfter(response, status);
  return status;
}

Dialect OpenAiClient::Known(const std::string& schema_name) const {
  const std::lock_guard lock(mutex_);
  Dialect dialect = dialect_;
  const auto form = form_of_schema_.find(schema_name);
  if (form != form_of_schema_.end()) dialect.form = std::max(dialect.form, form->second);
  return dialect;
}

void OpenAiClient::Learn(const ChatRequest& request, const Attempt& attempt, const ChatAnswer& answer) {
  const std::lock_guard lock(mutex_);
  if (attempt.dialect_is_new) {
    const Dialect known = dialect_;
    dialect_ = attempt.dialect;
    dialect_.thinks = known.thinks;
    dialect_.schema_in_prompt = known.schema_in_prompt;
    if (attempt.schema_rejected) {
      form_of_schema_[request.schema_name] = attempt.dialect.form;
      dialect_.form = known.form;
    }
  }
  // An answer that had no room for any text was thought away, whether the server says so or not.
  const bool thought_away = answer.finish == FinishReason::kLength && answer.text.empty();
  dialect_.thinks = dialect_.thinks || attempt.thought || thought_away;
  LearnWhetherSchemasAreKept(request, attempt.dialect, answer);
}

void OpenAiClient::LearnWhetherSchemasAreKept(const ChatRequest& request, const Dialect& dialect,
                                              const ChatAnswer& answer) {
  const bool by_schema = !request.schema.empty() && dialect.form == config::v1::ANSWER_FORM_JSON_SCHEMA;
  if (!by_schema || dialect.schema_in_prompt || schemas_are_kept_ || answer.finish != FinishReason::kStop) return;
  schemas_are_kept_ = KeepsTo(request.schema, answer.text);
  dialect_.schema_in_prompt = !schemas_are_kept_;
}

}  // namespace flair::llm
