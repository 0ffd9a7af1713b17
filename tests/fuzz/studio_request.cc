// SPDX-License-Identifier: GPL-3.0-or-later
// A request to the studio. What must hold:
//   its head is let in only with the token in it, and whoever is not let in gets an answer with a status of refusal, or
//   the cookie;
//   its body is no message, or one that is written as JSON and read again: then the JSON stays the same.
#include <boost/asio/buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <string>

#include "flair/v1/studio_service.pb.h"
#include "fmt/format.h"
#include "studio/gateway/admission.h"
#include "studio/gateway/connect_protocol.h"
#include "studio/gateway/json_messages.h"
#include "tests/fuzz/targets.h"

namespace flair::fuzz {
namespace {

namespace http = boost::beast::http;

// Short, so that a fuzzer can find its way with it.
constexpr char kToken[] = "t0k3n";
constexpr int kPort = 8080;
constexpr char kEnd[] = "\r\n\r\n";

void CheckHead(std::string_view bytes) {
  http::request_parser<http::string_body> parser;
  parser.header_limit(16 * 1024);
  boost::system::error_code error;
  parser.put(boost::asio::buffer(bytes), error);
  if (error || !parser.is_header_done()) return;
  const studio::Admission admission(kToken, "http", {"127.0.0.1", "localhost"}, kPort);
  const auto& head = parser.get().base();
  const std::optional<studio::Reply> reply = admission.Answer(head);
  const bool has_token = bytes.find(kToken) != std::string_view::npos;
  Require(has_token || reply.has_value(), "nobody is let in without the token");
  if (!reply.has_value()) return;
  Require(reply->status == 401 || reply->status == 403 || (reply->status == 303 && has_token), "others are refused");
  const std::string written = studio::HeadOf(*reply);
  Require(written.find(kEnd) == written.size() - 4, "an answer has one head");
  (void)studio::IsContentType(studio::HeaderOf(head, "Content-Type"), studio::kUnaryType);
  const auto timeout = studio::ParseTimeout(studio::HeaderOf(head, "Connect-Timeout-Ms"));
  Require(!timeout.ok() || *timeout >= absl::ZeroDuration(), "time does not run backwards");
}

void CheckMessage(const std::string& type, std::string_view json) {
  absl::StatusOr<grpc::ByteBuffer> bytes = studio::BytesFromJson(type, json);
  if (!bytes.ok()) {
    Require(absl::IsInvalidArgument(bytes.status()) && bytes.status().message().size() < 500, "a refusal is short");
    Require(!studio::ErrorJson(bytes.status()).empty(), "a refusal can be told");
    return;
  }
  const absl::StatusOr<std::string> once = studio::JsonFromBytes(type, *bytes);
  // Too deep to be written, though not to be read.
  if (!once.ok()) return;
  bytes = studio::BytesFromJson(type, *once);
  Require(bytes.ok(), fmt::format("what is written is read: {}", std::string(bytes.status().message())));
  const absl::StatusOr<std::string> twice = studio::JsonFromBytes(type, *bytes);
  Require(twice.ok() && *twice == *once, "what is read again stays the same");
}

}  // namespace

void StudioRequest(std::string_view bytes) {
  CheckHead(bytes);
  const size_t end = bytes.find(kEnd);
  std::string_view body = end == std::string_view::npos ? bytes : bytes.substr(end + 4);
  CheckMessage(std::string(v1::ActRequest::descriptor()->full_name()), body);
  CheckMessage(std::string(v1::CreateDocumentRequest::descriptor()->full_name()), body);
  const absl::StatusOr<std::string_view> message = studio::MessageOf(body);
  if (!message.ok()) return;
  Require(message->size() + 5 == body.size(), "an envelope holds all that follows");
  Require(studio::Envelope(*message) == body, "an envelope is written as it was read");
}

}  // namespace flair::fuzz
