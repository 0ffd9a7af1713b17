// SPDX-License-Identifier: GPL-3.0-or-later
#include "studio/gateway/admission.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <openssl/crypto.h>

#include <algorithm>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/str_split.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::studio {
namespace {

namespace http = boost::beast::http;

constexpr std::string_view kTokenQuery = "token=";

absl::string_view AsAbsl(std::string_view text) { return {text.data(), text.size()}; }

std::string_view QueryOf(const RequestHead& head) {
  const std::string_view target(head.target().data(), head.target().size());
  const size_t mark = target.find('?');
  return mark == std::string_view::npos ? std::string_view() : target.substr(mark + 1);
}

Reply Refused(const RequestHead& head, absl::StatusCode code, std::string_view words) {
  const int status = code == absl::StatusCode::kUnauthenticated ? 401 : 403;
  Reply reply = head.method() == http::verb::post ? ErrorReply(status, absl::Status(code, AsAbsl(words)))
                                                  : TextReply(status, fmt::format("{}\n", words));
  reply.close = true;
  return reply;
}

// A link on a page of another site leads here without the cookie, which is for our own pages only. So the browser comes
// again from this page; nothing that another site does with it comes of that.
Reply NoCookieReply(const RequestHead& head) {
  constexpr std::string_view kWords = "Open the address that flair studio printed: it holds the token of this studio.";
  if (head.method() == http::verb::post) return Refused(head, absl::StatusCode::kUnauthenticated, kWords);
  const bool again = PathOf(head) == "/" && HeaderOf(head, "Sec-Fetch-Site") == "cross-site";
  Reply reply = TextReply(
      401, fmt::format("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">{}<title>Flair studio</title>"
                       "</head><body><p>{}</p></body></html>\n",
                       again ? "<meta http-equiv=\"refresh\" content=\"0; url=/\">" : "", kWords));
  reply.headers[0].second = "text/html; charset=utf-8";
  reply.close = true;
  return reply;
}

}  // namespace

std::string_view HeaderOf(const RequestHead& head, std::string_view name) {
  const auto [first, end] = head.equal_range(boost::string_view(name.data(), name.size()));
  if (first == end || std::next(first) != end) return "";
  return {first->value().data(), first->value().size()};
}

std::string_view PathOf(const RequestHead& head) {
  const std::string_view target(head.target().data(), head.target().size());
  return target.substr(0, target.find('?'));
}

Admission::Admission(std::string token, std::string_view scheme, const std::vector<std::string>& hosts, int port)
    : token_(std::move(token)), scheme_(scheme), cookie_(fmt::format("flair_studio_{}", port)) {
  // Browsers leave out the usual port.
  const bool is_usual = port == (scheme == "https" ? 443 : 80);
  for (const std::string& host : hosts) hosts_.push_back(is_usual ? host : fmt::format("{}:{}", host, port));
}

bool Admission::IsOurHost(std::string_view host) const {
  return std::ranges::any_of(hosts_,
                             [host](const std::string& own) { return absl::EqualsIgnoreCase(AsAbsl(host), own); });
}

// Whether a browser says that a page of another origin is behind the request. Links to "/" may come from anywhere.
bool Admission::IsForeign(const RequestHead& head) const {
  const std::string_view site = HeaderOf(head, "Sec-Fetch-Site");
  if (head.count("Origin") > 0) {
    const std::string own = fmt::format("{}://{}", scheme_, HeaderOf(head, "Host"));
    return !absl::EqualsIgnoreCase(AsAbsl(HeaderOf(head, "Origin")), own);
  }
  if (head.method() == http::verb::post) return site != "same-origin";
  if (head.count("Sec-Fetch-Site") == 0 || site == "same-origin" || site == "none") return false;
  return PathOf(head) != "/" || HeaderOf(head, "Sec-Fetch-Dest") != "document";
}

bool Admission::IsToken(std::string_view value) const {
  return value.size() == token_.size() && CRYPTO_memcmp(value.data(), token_.data(), token_.size()) == 0;
}

bool Admission::HasCookie(const RequestHead& head) const {
  for (const absl::string_view pair : absl::StrSplit(AsAbsl(HeaderOf(head, "Cookie")), ';')) {
    const std::vector<absl::string_view> parts = absl::StrSplit(pair, absl::MaxSplits('=', 1));
    if (parts.size() != 2 || absl::StripAsciiWhitespace(parts[0]) != cookie_) continue;
    const absl::string_view value = absl::StripAsciiWhitespace(parts[1]);
    if (IsToken({value.data(), value.size()})) return true;
  }
  return false;
}

std::optional<Reply> Admission::Answer(const RequestHead& head) const {
  if (!IsOurHost(HeaderOf(head, "Host"))) {
    return Refused(head, absl::StatusCode::kPermissionDenied,
                   fmt::format("The studio answers as {} only.", fmt::join(hosts_, ", ")));
  }
  if (IsForeign(head)) {
    return Refused(head, absl::StatusCode::kPermissionDenied, "The studio answers its own pages only.");
  }
  const std::string_view query = QueryOf(head);
  if (head.method() == http::verb::get && PathOf(head) == "/" && query.starts_with(kTokenQuery) &&
      IsToken(query.substr(kTokenQuery.size()))) {
    Reply reply = TextReply(303, "");
    reply.headers.emplace_back("Location", "/");
    reply.headers.emplace_back("Set-Cookie", fmt::format("{}={}; Path=/; HttpOnly; SameSite=Strict{}", cookie_, token_,
                                                         scheme_ == "https" ? "; Secure" : ""));
    return reply;
  }
  if (!HasCookie(head)) return NoCookieReply(head);
  return std::nullopt;
}

}  // namespace flair::studio
