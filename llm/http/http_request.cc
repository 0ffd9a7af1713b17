// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>

#include "absl/strings/match.h"
#include "llm/http/http_client.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::llm {
namespace {

// Bytes that may stand in the name of a header (RFC 9110, token).
bool IsTokenByte(unsigned char c) {
  return std::isalnum(c) != 0 ||
         std::string_view("!#$%&'*+-.^_`|~").find(static_cast<char>(c)) != std::string_view::npos;
}

// Whether what stands before the first '/', '?' or '#' can only be a user and the beginning of a password that holds
// one of them: "http://user:pa/ss@host".
bool SplitsPassword(std::string_view url) {
  const size_t scheme_end = url.find("://");
  std::string_view host = url.substr(scheme_end == std::string_view::npos ? 0 : scheme_end + 3);
  const size_t end = std::min(host.find_first_of("/?#"), host.size());
  const std::string_view rest = host.substr(end);
  host = host.substr(0, end);
  const size_t colon = host.find(':');
  if (rest.find('@') == std::string_view::npos || host.find('@') != std::string_view::npos || host.starts_with('[') ||
      colon == std::string_view::npos) {
    return false;
  }
  return !std::ranges::all_of(host.substr(colon + 1), [](unsigned char c) { return std::isdigit(c) != 0; });
}

bool IsControlByte(unsigned char c) { return (c < 0x20 && c != '\t') || c == 0x7f; }

}  // namespace

std::string_view HttpResponse::header(std::string_view name) const {
  const auto found = std::ranges::find(headers, name, &HttpHeader::name);
  return found == headers.end() ? std::string_view() : std::string_view(found->value);
}

std::string PublicAddress(std::string_view url) {
  if (SplitsPassword(url)) return "(an address with a password)";
  url = url.substr(0, url.find_first_of("?#"));
  const size_t scheme_end = url.find("://");
  const size_t host_begin = scheme_end == std::string_view::npos ? 0 : scheme_end + 3;
  const size_t host_end = std::min(url.find('/', host_begin), url.size());
  const size_t at = url.substr(0, host_end).rfind('@');
  std::string address(url.substr(0, host_begin));
  address += url.substr(at == std::string_view::npos || at < host_begin ? host_begin : at + 1);
  return address;
}

absl::Status CheckHeader(const HttpHeader& header) {
  if (header.name.empty() || !std::ranges::all_of(header.name, IsTokenByte)) {
    return InvalidArgument("header '{}': not a name of a header", header.name);
  }
  if (std::ranges::any_of(header.value, IsControlByte)) {
    return InvalidArgument("header '{}': its value holds a line break or another control character", header.name);
  }
  return absl::OkStatus();
}

absl::Status CheckRequest(const HttpRequest& request) {
  if (!absl::StartsWithIgnoreCase(request.url, "http://") && !absl::StartsWithIgnoreCase(request.url, "https://")) {
    return InvalidArgument("'{}' is not an address; it must begin with http:// or https://",
                           PublicAddress(request.url));
  }
  if (SplitsPassword(request.url)) {
    return absl::InvalidArgumentError(
        "the address holds a password with '/', '?' or '#', which must be written %2F, %3F or %23");
  }
  if (std::ranges::any_of(request.url, [](unsigned char c) { return IsControlByte(c) || c == ' '; })) {
    return absl::InvalidArgumentError("the address holds a space or a control character");
  }
  for (const HttpHeader& header : request.headers) RETURN_IF_ERROR(CheckHeader(header));
  return absl::OkStatus();
}

}  // namespace flair::llm
