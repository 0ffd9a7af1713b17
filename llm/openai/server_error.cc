// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "absl/strings/numbers.h"
#include "absl/time/time.h"
#include "llm/openai/reply_reader.h"

namespace flair::llm {
namespace {

using nlohmann::json;

// A text or number as text; else empty.
std::string TextOf(const json* value) {
  if (value == nullptr) return "";
  if (value->is_string()) return value->get<std::string>();
  return value->is_number_integer() ? value->dump() : "";
}

// FastAPI's list of faults: [{"loc": ["body", "seed"], "type": "extra_forbidden", "msg": "..."}].
ServerError ReadDetail(const json& detail) {
  ServerError error;
  if (detail.is_string()) error.message = detail.get<std::string>();
  if (!detail.is_array() || detail.empty()) return error;
  const json& first = detail.front();
  error.message = TextOf(Field(first, "msg"));
  error.type = TextOf(Field(first, "type"));
  const json* const place = Field(first, "loc");
  if (place != nullptr && place->is_array() && !place->empty()) error.param = TextOf(&place->back());
  return error;
}

constexpr size_t kMessageByteLimit = 300;
constexpr size_t kSecretByteCount = 6;
constexpr size_t kQuoteByteCount = 20;

// Whether the text holds a part of `source` of `length` bytes, or all of a shorter one.
bool Quotes(std::string_view text, std::string_view source, size_t length) {
  if (source.empty()) return false;
  if (source.size() <= length) return text.find(source) != std::string_view::npos;
  if (text.size() < length) return false;
  for (size_t i = 0; i + length <= text.size(); ++i) {
    if (source.find(text.substr(i, length)) != std::string_view::npos) return true;
  }
  return false;
}

bool IsConfidential(std::string_view text, const Confidential& confidential) {
  return std::ranges::any_of(confidential.secrets,
                             [&](const std::string& secret) { return Quotes(text, secret, kSecretByteCount); }) ||
         std::ranges::any_of(confidential.messages,
                             [&](const Message& message) { return Quotes(text, message.text, kQuoteByteCount); });
}

// One printable line of the server's text, cut between characters.
std::string Shown(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  if (text.size() <= kMessageByteLimit) return text;
  size_t end = kMessageByteLimit;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

std::string Describe(int http_status, const ServerError& error, std::string text, const Confidential& confidential) {
  // Of a rejected key servers show parts, crossed out or not.
  const bool of_key = http_status == 401 || http_status == 403 || http_status == 407;
  for (const auto& [name, value] : {std::pair("", error.type),
                                    {"code ", error.code},
                                    {"field ", error.param},
                                    {"", of_key ? std::string() : error.message}}) {
    if (value.empty()) continue;
    text += IsConfidential(value, confidential) ? ", a text that quotes the request"
                                                : fmt::format(", {}{}", name, Shown(value));
  }
  return text;
}

std::optional<double> ReadNumber(const std::string& text) {
  double number = 0;
  return absl::SimpleAtod(text, &number) && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::optional<absl::Duration> ReadRetryAfter(const HttpResponse& response) {
  const auto milliseconds = ReadNumber(std::string(response.header("retry-after-ms")));
  if (milliseconds.has_value()) return absl::Milliseconds(*milliseconds);
  const std::string value(response.header("retry-after"));
  if (const auto seconds = ReadNumber(value)) return absl::Seconds(*seconds);
  absl::Time then, now;
  std::string ignored;
  constexpr char kFormat[] = "%a, %d %b %Y %H:%M:%S GMT";
  // Against the server's own clock; ours may be wrong.
  if (!absl::ParseTime(kFormat, value, &then, &ignored) ||
      !absl::ParseTime(kFormat, std::string(response.header("date")), &now, &ignored)) {
    return std::nullopt;
  }
  return then - now;
}

bool IsSpent(const ServerError& error) {
  for (const std::string& text : {error.code, error.type}) {
    if (text == "insufficient_quota" || text == "billing_hard_limit_reached" || text == "billing_not_active")
      return true;
  }
  return false;
}

absl::StatusCode CodeOf(int http_status, const ServerError& error) {
  switch (http_status) {
    case 401:
      return absl::StatusCode::kUnauthenticated;
    case 403:
    case 407:
      return absl::StatusCode::kPermissionDenied;
    case 402:
      return absl::StatusCode::kFailedPrecondition;
    case 404:
    case 410:
      return absl::StatusCode::kNotFound;
    case 429:
      return IsSpent(error) ? absl::StatusCode::kFailedPrecondition : absl::StatusCode::kUnavailable;
    case 408:
    case 409:
    case 425:
      return absl::StatusCode::kUnavailable;
    default:
      if (http_status / 100 == 3) return absl::StatusCode::kNotFound;
      return http_status / 100 == 4 ? absl::StatusCode::kInvalidArgument : absl::StatusCode::kUnavailable;
  }
}

}  // namespace

ServerError ReadServerError(std::string_view body) {
  json root = ParseJson(body);
  if (root.is_array() && !root.empty()) root = json(root.front());
  if (!root.is_object()) return {};
  if (const json* const detail = Field(root, "detail")) return ReadDetail(*detail);
  const json* error = Field(root, "error");
  if (error != nullptr && error->is_string())
    return {.message = error->get<std::string>(), .type = "", .code = "", .param = ""};
  if (error == nullptr || !error->is_object()) error = &root;
  // FastAPI's list, wrapped once more.
  if (const json* const message = Field(*error, "message"); message != nullptr && message->is_object()) {
    if (const json* const detail = Field(*message, "detail")) return ReadDetail(*detail);
  }
  ServerError read{.message = TextOf(Field(*error, "message")),
                   .type = TextOf(Field(*error, "type")),
                   .code = TextOf(Field(*error, "code")),
                   .param = TextOf(Field(*error, "param"))};
  // Azure's filter says more precisely inside.
  if (const json* const inner = Field(*error, "innererror"); inner != nullptr && read.code.empty()) {
    read.code = TextOf(Field(*inner, "code"));
  }
  return read;
}

int HttpStatusOf(const ServerError& error) {
  int status = 0;
  if (absl::SimpleAtoi(error.code, &status) && status >= 400 && status < 600) return status;
  static constexpr std::pair<std::string_view, int> kKinds[] = {{"invalid_api_key", 401},
                                                                {"authentication_error", 401},
                                                                {"permission_error", 403},
                                                                {"model_not_found", 404},
                                                                {"not_found_error", 404},
                                                                {"insufficient_quota", 429},
                                                                {"billing_hard_limit_reached", 429},
                                                                {"billing_not_active", 429},
                                                                {"rate_limit_exceeded", 429},
                                                                {"rate_limit_error", 429},
                                                                {"context_length_exceeded", 400},
                                                                {"content_filter", 400},
                                                                {"content_policy_violation", 400},
                                                                {"invalid_request_error", 400}};
  // The code says more than the type.
  for (const std::string& text : {error.code, error.type}) {
    const auto found = std::ranges::find(kKinds, std::string_view(text), &std::pair<std::string_view, int>::first);
    if (found != std::end(kKinds)) return found->second;
  }
  return 500;
}

absl::Status StatusOf(int http_status, const ServerError& error, std::string where, const Confidential& confidential) {
  return {CodeOf(http_status, error), Describe(http_status, error, std::move(where), confidential)};
}

void AddRetryAfter(const HttpResponse& response, absl::Status& status) {
  if (const auto delay = ReadRetryAfter(response)) SetRetryAfter(status, *delay);
}

bool IsRefusal(const ServerError& error) {
  return error.code == "content_filter" || error.code == "content_policy_violation" ||
         error.code == "ResponsibleAIPolicyViolation" || error.type == "content_filter";
}

}  // namespace flair::llm
