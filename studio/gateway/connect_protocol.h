// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the Connect protocol (connectrpc.com/docs/protocol) that browsers use, with JSON:
//   unary      POST, application/json: one message each way; an error is {"code", "message"} with an HTTP status
//   streaming  POST, application/connect+json: one message in its envelope, many back; the last envelope has the flag
//              "end of stream" and holds {} or {"error": {"code", "message"}}
// An envelope is one byte of flags, the length of the message in four bytes, the greatest first, and the message.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "absl/time/time.h"

namespace flair::studio {

inline constexpr std::string_view kUnaryType = "application/json";
inline constexpr std::string_view kStreamType = "application/connect+json";

// Whether a header Content-Type says `type`; the only parameter that it may have is charset=utf-8.
bool IsContentType(std::string_view header, std::string_view type);

// Such as "invalid_argument"; "unknown" for codes that there are not.
std::string_view CodeName(absl::StatusCode code);
int HttpStatusOf(absl::StatusCode code);

// {"code":"not_found","message":"..."}; what is not UTF-8 in the message is replaced.
std::string ErrorJson(const absl::Status& error);

// Header and content of a message in a stream.
std::string Envelope(std::string_view message);
// The last envelope of a stream that has ended so.
std::string EndOfStream(const absl::Status& status);
// The message of a body that is one envelope. Lives as long as the body.
absl::StatusOr<std::string_view> MessageOf(std::string_view body);

// Of a header Connect-Timeout-Ms: 1 to 10 digits.
absl::StatusOr<absl::Duration> ParseTimeout(std::string_view header);

}  // namespace flair::studio
