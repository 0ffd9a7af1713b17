// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "llm/openai/openai_options.h"

namespace flair::llm {

// Where requests go, OpenAI's address or Azure's.
std::string CompletionsUrl(const OpenAiOptions& options);

// With the key in the header that the server looks for.
std::vector<HttpHeader> RequestHeaders(const OpenAiOptions& options);

// The key and the values of the user's own headers.
std::vector<std::string> SecretsOf(const OpenAiOptions& options);

// What decides the answers, in a line; nothing secret.
std::string IdentityOf(const OpenAiOptions& options);

}  // namespace flair::llm
