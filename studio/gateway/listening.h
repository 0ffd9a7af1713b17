// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "studio/gateway/gateway.h"

namespace flair::studio {

// Where the gateway listens, and what browsers call it.
struct Listening {
  boost::asio::ip::tcp::endpoint endpoint;
  // Hosts of addresses, without port; the first is for url().
  std::vector<std::string> hosts;
  // nullptr: plain HTTP.
  std::unique_ptr<boost::asio::ssl::context> tls;

  std::string_view scheme() const { return tls == nullptr ? "http" : "https"; }
};

// INVALID_ARGUMENT for addresses that other machines reach without TLS, and for the files of TLS.
absl::StatusOr<Listening> ReadListening(const GatewayOptions& options);

}  // namespace flair::studio
