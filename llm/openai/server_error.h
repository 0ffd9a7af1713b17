// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "llm/client/llm_client.h"
#include "llm/http/http_request.h"

namespace flair::llm {

// What a server says about an error; fields that it does not have are empty. May quote the request.
struct ServerError {
  std::string message;
  std::string type;
  std::string code;
  std::string param;
};

// Reads the forms that OpenAI, Azure, vLLM, llama.cpp, Ollama and gateways use; of anything else it is empty.
ServerError ReadServerError(std::string_view body);

// The HTTP status of an error that came inside a reply of status 200: the one that it names as its code, or that its
// kind is usually sent with; 500, which may be tried again, for anything else.
int HttpStatusOf(const ServerError& error);

// What must not be in an error.
struct Confidential {
  // Keys and values of headers.
  std::vector<std::string> secrets;
  std::span<const Message> messages;
};

// The error for an HTTP status other than 2xx, as LlmClient says. `where` begins its text, such as the address and
// "HTTP 429". Texts of the server that quote what is confidential are left out.
absl::Status StatusOf(int http_status, const ServerError& error, std::string where, const Confidential& confidential);

// When the server wants to be asked again: Retry-After in seconds or, given a Date too, as a date; retry-after-ms.
void AddRetryAfter(const HttpResponse& response, absl::Status& status);

// Whether the provider refuses to answer this question.
bool IsRefusal(const ServerError& error);

}  // namespace flair::llm
