// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "flair/config/v1/llm_config.pb.h"
#include "llm/http/http_request.h"

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

}  // namespace flair::llm
