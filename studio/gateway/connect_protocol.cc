// SPDX-License-Identifier: GPL-3.0-or-later
#include "studio/gateway/connect_protocol.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "nlohmann/json.hpp"
#include "worker_runtime/status/status_macros.h"

namespace flair::studio {
namespace {

constexpr size_t kEnvelopeHeader = 5;
constexpr char kEndFlag = 2;
constexpr size_t kTimeoutDigits = 10;

struct Code {
  std::string_view name;
  int http_status;
};

// By the number of the code.
constexpr std::array<Code, 17> kCodes = {{{"ok", 200},
                                          {"canceled", 499},
                                          {"unknown", 500},
                                          {"invalid_argument", 400},
                                          {"deadline_exceeded", 504},
                                          {"not_found", 404},
                                          {"already_exists", 409},
                                          {"permission_denied", 403},
                                          {"resource_exhausted", 429},
                                          {"failed_precondition", 400},
                                          {"aborted", 409},
                                          {"out_of_range", 400},
                                          {"unimplemented", 501},
                                          {"internal", 500},
                                          {"unavailable", 503},
                                          {"data_loss", 500},
                                          {"unauthenticated", 401}}};

const Code& CodeOf(absl::StatusCode code) {
  const auto index = static_cast<size_t>(code);
  return kCodes[index < kCodes.size() ? index : static_cast<size_t>(absl::StatusCode::kUnknown)];
}

nlohmann::json ErrorObject(const absl::Status& error) {
  nlohmann::json object = {{"code", CodeName(error.code())}};
  if (!error.message().empty()) object["message"] = std::string(error.message());
  return object;
}

std::string Written(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string Enveloped(char flags, std::string_view message) {
  const auto size = static_cast<uint32_t>(message.size());
  std::string envelope;
  envelope.reserve(kEnvelopeHeader + message.size());
  envelope += flags;
  for (int shift = 24; shift >= 0; shift -= 8) envelope += static_cast<char>(size >> shift & 0xff);
  envelope += message;
  return envelope;
}

}  // namespace

bool IsContentType(std::string_view header, std::string_view type) {
  const size_t semicolon = header.find(';');
  const auto trimmed = [](std::string_view text) { return absl::StripAsciiWhitespace({text.data(), text.size()}); };
  if (!absl::EqualsIgnoreCase(trimmed(header.substr(0, semicolon)), {type.data(), type.size()})) return false;
  return semicolon == std::string_view::npos ||
         absl::EqualsIgnoreCase(trimmed(header.substr(semicolon + 1)), "charset=utf-8");
}

std::string_view CodeName(absl::StatusCode code) { return CodeOf(code).name; }

int HttpStatusOf(absl::StatusCode code) { return CodeOf(code).http_status; }

std::string ErrorJson(const absl::Status& error) { return Written(ErrorObject(error)); }

std::string Envelope(std::string_view message) { return Enveloped(0, message); }

std::string EndOfStream(const absl::Status& status) {
  nlohmann::json end = nlohmann::json::object();
  if (!status.ok()) end["error"] = ErrorObject(status);
  return Enveloped(kEndFlag, Written(end));
}

absl::StatusOr<std::string_view> MessageOf(std::string_view body) {
  if (body.size() < kEnvelopeHeader) return InvalidArgument("the body has no envelope, which begins with five bytes");
  if (body[0] != 0) {
    return InvalidArgument("the envelope has flags {}: expected 0, not compressed and not the end of a stream",
                           static_cast<int>(static_cast<unsigned char>(body[0])));
  }
  uint32_t size = 0;
  for (size_t i = 1; i < kEnvelopeHeader; ++i) size = size << 8 | static_cast<unsigned char>(body[i]);
  if (size != body.size() - kEnvelopeHeader) {
    return InvalidArgument("the envelope announces {} bytes, {} follow: expected one message and nothing after it",
                           size, body.size() - kEnvelopeHeader);
  }
  return body.substr(kEnvelopeHeader);
}

absl::StatusOr<absl::Duration> ParseTimeout(std::string_view header) {
  const bool digits = std::ranges::all_of(header, [](char c) { return c >= '0' && c <= '9'; });
  if (header.empty() || header.size() > kTimeoutDigits || !digits) {
    return InvalidArgument("Connect-Timeout-Ms should be a number of 1 to 10 digits");
  }
  int64_t milliseconds = 0;
  std::from_chars(header.data(), header.data() + header.size(), milliseconds);
  return absl::Milliseconds(milliseconds);
}

}  // namespace flair::studio
