// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "llm/client/llm_client.h"
#include "llm/http/http_client.h"

namespace flair::llm {

// Reading JSON from a stranger: nothing is what it should be.

// Parses; discarded (is_discarded()) when it is no JSON or nests deeper than anything of the protocol does, so that
// what walks over it needs no deep stack.
inline nlohmann::json ParseJson(std::string_view text) {
  constexpr int kDepthLimit = 64;
  bool too_deep = false;
  const auto keep = [&](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
    too_deep = too_deep || depth > kDepthLimit;
    return !too_deep;
  };
  nlohmann::json value = nlohmann::json::parse(text, keep, false);
  return too_deep ? nlohmann::json(nlohmann::json::value_t::discarded) : value;
}

// The member of an object; null when `value` is no object, or has none of that name, or it is JSON's null.
inline const nlohmann::json* Field(const nlohmann::json& value, const char* name) {
  if (!value.is_object()) return nullptr;
  const auto found = value.find(name);
  return found == value.end() || found->is_null() ? nullptr : &*found;
}

// A text member; empty when it is none.
inline std::string TextField(const nlohmann::json& value, const char* name) {
  const nlohmann::json* const field = Field(value, name);
  return field != nullptr && field->is_string() ? field->get<std::string>() : std::string();
}

// A count, [0, 10^9]; none when it is anything else.
inline std::optional<int64_t> CountField(const nlohmann::json& value, const char* name) {
  const nlohmann::json* const field = Field(value, name);
  if (field == nullptr || !field->is_number_integer()) return std::nullopt;
  // A count beyond int64 is stored unsigned.
  if (field->is_number_unsigned() && field->get<uint64_t>() > 1000000000u) return std::nullopt;
  const int64_t count = field->get<int64_t>();
  return count >= 0 ? std::optional(count) : std::nullopt;
}

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

// The data of each server-sent event of a stream, in order; names, ids and comments of events are skipped. Lines end in
// LF, CR LF or CR. An event that no empty line ended counts too. Any bytes are good input.
std::vector<std::string> EventsOf(std::string_view stream);

// What a reply is read with; all is borrowed.
struct ReplyContext {
  const std::string& address;  // begins every error
  const ChatRequest& request;
  const Confidential& confidential;
  const std::string& model;  // stands in for a name that the server does not say
};

// A reply of status 2xx.
struct ChatReply {
  ChatAnswer answer;
  bool thought = false;  // the model thought before it answered
};

// Reads the body of a reply, a whole completion or, of a server that was asked to stream, its events; one that knows no
// streams sends a whole completion then, too. Errors: DATA_LOSS when it is not of the protocol (HTML, empty, not JSON,
// no choices); UNAVAILABLE when a stream ends early; that of an error inside the reply.
absl::StatusOr<ChatReply> ReadReply(std::string_view body, bool streamed, const ReplyContext& context);

}  // namespace flair::llm
