// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/config/v1/llm_config.pb.h"
#include "llm/client/llm_client.h"
#include "llm/http/http_client.h"
#include "llm/openai/reply_reader.h"
#include "worker_runtime/clock/clock.h"

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

// A model behind the chat protocol of OpenAI, as spoken by OpenAI, Azure, vLLM, llama.cpp, Ollama and gateways. One
// attempt an Ask, but for requests that the server rejects because of a field that it does not know (response_format,
// max_tokens, temperature, seed, stream ...): those are asked again at once without it, and what the server took is
// remembered. So is that a server takes schemas without keeping to them, which are then told in the prompt too, and
// that a model thinks before it answers, which then gets room for that. Thread-safe.
//
// Errors as LlmClient says; RetryAfter() of an UNAVAILABLE tells what the server wants. Also FAILED_PRECONDITION when
// the server's certificate is not trusted, and FAILED_PRECONDITION when the account at the provider is spent. An answer
// that the server or the model refuses to give is an answer with FinishReason::kRefused.
class OpenAiClient final : public LlmClient {
 public:
  // `clock` is that of the calls' deadlines and outlives this.
  OpenAiClient(OpenAiOptions options, HttpOptions http, const runtime::Clock& clock = runtime::SystemClock());

  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext& call) override;
  std::string identity() const override { return IdentityOf(options_); }
  int concurrency() const override { return 64; }

 private:
  // A request in the dialect in which it is sent.
  struct Attempt {
    Dialect dialect;
    // The dialect is weaker than the known one, which learns it when the server takes it.
    bool dialect_is_new = false;
    // That is because of this schema alone.
    bool schema_rejected = false;
    // The model thought before it answered.
    bool thought = false;
  };

  // The dialect that the server is known to take.
  Dialect Known(const std::string& schema_name) const;
  // Learns from a request that the server took, and from its answer.
  void Learn(const ChatRequest& request, const Attempt& attempt, const ChatAnswer& answer);
  void LearnWhetherSchemasAreKept(const ChatRequest& request, const Dialect& dialect, const ChatAnswer& answer);
  // What an HTTP status other than 2xx means for the question, when no other dialect helps.
  absl::StatusOr<ChatAnswer> Failure(const HttpResponse& response, const ServerError& error,
                                     const Confidential& confidential) const;

  const OpenAiOptions options_;
  HttpClient http_;
  const std::string url_;
  const std::string address_;
  mutable std::mutex mutex_;
  Dialect dialect_;
  // Forms of those schemas that the server did not take in the dialect's.
  std::map<std::string, config::v1::AnswerForm> form_of_schema_;
  // An answer kept to its schema, which no server does by chance.
  bool schemas_are_kept_ = false;
};

}  // namespace flair::llm
