// SPDX-License-Identifier: GPL-3.0-or-later
#include "studio/gateway/listening.h"

#include <algorithm>
#include <boost/asio/ip/address.hpp>

#include "absl/time/clock.h"
#include "worker_runtime/security/security.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::studio {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using Context = asio::ssl::context;

const std::vector<std::string>& OwnHosts() {
  static const std::vector<std::string>& hosts = *new std::vector<std::string>{"127.0.0.1", "localhost", "[::1]"};
  return hosts;
}

bool IsOwn(const std::string& host) { return std::ranges::find(OwnHosts(), host) != OwnHosts().end(); }

absl::StatusOr<asio::ip::address> AddressOf(const std::string& host) {
  if (host == "localhost") return asio::ip::address(asio::ip::address_v4::loopback());
  error_code error;
  const bool brackets = host.starts_with("[") && host.ends_with("]");
  const auto address = asio::ip::make_address(brackets ? host.substr(1, host.size() - 2) : host, error);
  if (error) return InvalidArgument("\"{}\" is no IP address", host);
  return address;
}

absl::StatusOr<std::unique_ptr<Context>> ReadTls(const config::v1::TlsConfig& tls) {
  if (tls.certificate_path().empty() || tls.key_path().empty()) {
    return InvalidArgument("tls: certificate_path and key_path are needed");
  }
  if (tls.client_names_size() > 0) return InvalidArgument("tls.client_names: the studio asks for its token instead");
  RETURN_IF_ERROR(runtime::CheckTlsFiles(
      tls, absl::Now(),
      {.certificate = "tls.certificate_path", .key = "tls.key_path", .authority = "tls.authority_path"}));
  auto context = std::make_unique<Context>(Context::tls_server);
  error_code error;
  context->set_options(
      Context::default_workarounds | Context::no_sslv2 | Context::no_sslv3 | Context::no_tlsv1 | Context::no_tlsv1_1,
      error);
  if (!error) context->use_certificate_chain_file(tls.certificate_path(), error);
  if (!error) context->use_private_key_file(tls.key_path(), Context::pem, error);
  if (!error && tls.require_client_certificate()) {
    context->load_verify_file(tls.authority_path(), error);
    if (!error) context->set_verify_mode(asio::ssl::verify_peer | asio::ssl::verify_fail_if_no_peer_cert, error);
  }
  if (error) return InvalidArgument("tls: {}", error.message());
  return context;
}

}  // namespace

absl::StatusOr<Listening> ReadListening(const GatewayOptions& options) {
  const std::string host = options.listen_address.substr(0, options.listen_address.rfind(':'));
  const std::optional<int> port = runtime::PortOf(options.listen_address);
  const bool has_tls = options.tls.has_value();
  if (!port.has_value() || (!has_tls && !IsOwn(host))) {
    return InvalidArgument(
        "listen address \"{}\": expected 127.0.0.1:PORT, localhost:PORT or [::1]:PORT; to serve other machines too, "
        "the "
        "studio needs a certificate (tls)",
        options.listen_address);
  }
  Listening listening;
  ASSIGN_OR_RETURN(const asio::ip::address address, AddressOf(host));
  listening.endpoint = {address, static_cast<uint16_t>(*port)};
  listening.hosts = options.host_names;
  if (listening.hosts.empty() && address.is_unspecified()) {
    return InvalidArgument("listen address \"{}\": host_names should say what browsers call this machine",
                           options.listen_address);
  }
  if (listening.hosts.empty()) listening.hosts.push_back(host);
  listening.hosts.insert(listening.hosts.end(), OwnHosts().begin(), OwnHosts().end());
  if (has_tls) {
    ASSIGN_OR_RETURN(listening.tls, ReadTls(*options.tls));
  }
  return listening;
}

}  // namespace flair::studio
