// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/beast/http/message.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "studio/gateway/reply.h"

namespace flair::studio {

using RequestHead = boost::beast::http::request_header<>;

// A header that is there once, "" when it is not there; a header that is there twice never has the value of either.
std::string_view HeaderOf(const RequestHead& head, std::string_view name);

// The path of a request's target, without its query.
std::string_view PathOf(const RequestHead& head);

// Who may ask for anything. In this order:
//   Host     one of ours with our port: otherwise a name of another site's leads here (DNS rebinding)
//   Origin   ours, where the browser sends it; a POST needs it, or the browser's word that it comes from us
//   token    GET /?token=TOKEN with the right token sets the cookie and leads to "/", out of history and address bar
//   cookie   everything else needs it. Its name has the port: all ports of a host share their cookies
// A program on another port of this host sees the cookie when the same browser opens its pages: it is trusted as far as
// other programs of this machine are.
class Admission {
 public:
  // `scheme` is "http" or "https"; `hosts` without port.
  Admission(std::string token, std::string_view scheme, const std::vector<std::string>& hosts, int port);

  // The answer to a request that may not go on, mostly the last one of its connection; nothing when it may.
  std::optional<Reply> Answer(const RequestHead& head) const;

 private:
  bool IsOurHost(std::string_view host) const;
  bool IsForeign(const RequestHead& head) const;
  bool HasCookie(const RequestHead& head) const;
  bool IsToken(std::string_view value) const;

  const std::string token_;
  const std::string scheme_;
  // With port.
  std::vector<std::string> hosts_;
  const std::string cookie_;
};

}  // namespace flair::studio
