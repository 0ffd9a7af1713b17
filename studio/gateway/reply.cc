// SPDX-License-Identifier: GPL-3.0-or-later
#include "studio/gateway/reply.h"

#include <fmt/format.h>

#include <boost/beast/http/status.hpp>
#include <iterator>

#include "studio/gateway/connect_protocol.h"

namespace flair::studio {
namespace {

// blob: for pictures that the page makes, and for textures of models, which three.js fetches from itself.
constexpr std::string_view kGuards =
    "Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; "
    "font-src 'self'; connect-src 'self' blob:; worker-src 'self' blob:; frame-ancestors 'none'; base-uri 'none'; "
    "form-action 'none'\r\n"
    "X-Content-Type-Options: nosniff\r\n"
    "X-Frame-Options: DENY\r\n"
    "Referrer-Policy: no-referrer\r\n"
    "Cross-Origin-Opener-Policy: same-origin\r\n"
    "Cross-Origin-Resource-Policy: same-origin\r\n";

std::string_view Reason(int status) {
  if (status == 499) return "Client Closed Request";
  const auto reason = boost::beast::http::obsolete_reason(static_cast<boost::beast::http::status>(status));
  return {reason.data(), reason.size()};
}

}  // namespace

Reply TextReply(int status, std::string text) {
  return {.status = status,
          .headers = {{"Content-Type", "text/plain; charset=utf-8"}, {"Cache-Control", "no-store"}},
          .body = std::move(text)};
}

Reply ErrorReply(const absl::Status& error) { return ErrorReply(HttpStatusOf(error.code()), error); }

Reply ErrorReply(int http_status, const absl::Status& error) {
  return {.status = http_status,
          .headers = {{"Content-Type", "application/json"}, {"Cache-Control", "no-store"}},
          .body = ErrorJson(error)};
}

std::string HeadOf(const Reply& reply) {
  std::string head = fmt::format("HTTP/1.1 {} {}\r\n{}", reply.status, Reason(reply.status), kGuards);
  for (const auto& [name, value] : reply.headers) fmt::format_to(std::back_inserter(head), "{}: {}\r\n", name, value);
  // 304 has no body, and would have to name the length of another answer's.
  if (reply.status != 304) {
    fmt::format_to(std::back_inserter(head), "Content-Length: {}\r\n", reply.content().size());
  }
  if (reply.close) head += "Connection: close\r\n";
  return head + "\r\n";
}

std::string StreamHead(std::string_view content_type) {
  return fmt::format(
      "HTTP/1.1 200 OK\r\n{}Content-Type: {}\r\nCache-Control: no-store\r\nTransfer-Encoding: chunked\r\n\r\n", kGuards,
      content_type);
}

}  // namespace flair::studio
