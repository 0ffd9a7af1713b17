// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <mutex>
#include <string>

#include "llm/client/llm_client.h"
#include "llm/http/http_client.h"
#include "llm/openai/openai_options.h"
#include "worker_runtime/clock/clock.h"

namespace flair::llm {

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
