// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "llm/client/llm_client.h"
#include "llm/http/http_loop.h"
#include "llm/openai/openai_options.h"

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
  // `loop` outlives the client; the client outlives its asks or HttpLoop::Stop.
  OpenAiClient(OpenAiOptions options, HttpLoop& loop, HttpOptions http);
  ~OpenAiClient() override;

  void Ask(const ChatRequest& request, runtime::CallContext& call, AnswerCallback done) override;

  std::string identity() const override;

 private:
  class Impl;
  // Shared with the asks on their way.
  std::shared_ptr<Impl> impl_;
};

}  // namespace flair::llm
