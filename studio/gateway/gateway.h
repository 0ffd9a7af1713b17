// SPDX-License-Identifier: GPL-3.0-or-later
// The HTTP server between the studio's page in a browser and gRPC services.
//
//   GET  /                        the page and its files, see site.h
//   POST /flair.v1.Service/Method a call after the Connect protocol with JSON, see connect_protocol.h
//
// HTTP/1.1; other machines need TLS. Whoever wants anything needs the token of url(): GET /?token=... exchanges it for
// a cookie, see admission.h. What it holds at most, whoever calls: GatewayLimits.
#pragma once

#include <grpcpp/channel.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/config/v1/runtime_config.pb.h"

namespace flair::studio {

// A service that the page may call.
struct ExposedService {
  // Such as "flair.v1.StudioService". Its messages must be linked into the program.
  std::string full_name;
  // How it is called; its largest message bounds what a call may answer.
  std::shared_ptr<grpc::Channel> channel;
  // The methods that the page may call, unary or streaming from the server; all such methods when empty.
  std::vector<std::string> methods;
  // Those whose requests may be as large as GatewayLimits::upload_bytes.
  std::vector<std::string> upload_methods;
};

// Bounds of size and time. Memory beside the page itself stays below
//   connections * (2 * header_bytes + 64 KiB) + 3 * held_bytes + what calls have just answered:
// of each request body there is a JSON and a binary form and, while the former is read, the latter twice. With TLS each
// connection has 64 KiB more.
struct GatewayLimits {
  // Connections at a time; more wait in the kernel until one ends.
  int connections = 64;
  // Streams at a time, which hold a connection each; RESOURCE_EXHAUSTED beyond.
  int streams = 48;
  // First line and headers of a request.
  uint32_t header_bytes = 16 * 1024;
  // Body of a request.
  int64_t body_bytes = int64_t{4} << 20;
  // The same of upload methods.
  int64_t upload_bytes = int64_t{40} << 20;
  // Bodies and answers of all connections together; RESOURCE_EXHAUSTED beyond.
  int64_t held_bytes = int64_t{160} << 20;
  // From the beginning of a connection to its first byte (with TLS, to the end of the handshake), and from the first
  // byte of a request to the end of its headers.
  absl::Duration header_timeout = absl::Seconds(10);
  // Between two requests on a connection.
  absl::Duration idle_timeout = absl::Seconds(120);
  // Until a body is there.
  absl::Duration body_timeout = absl::Seconds(60);
  // Until the reader has taken an answer, or a message of a stream.
  absl::Duration write_timeout = absl::Seconds(60);
  // Deadline of unary calls, also when the page asks for a later one. Streams have only the one that the page asks for.
  absl::Duration call_timeout = absl::Minutes(10);
  // How long Stop waits for unary calls.
  absl::Duration drain_timeout = absl::Seconds(2);
};

struct GatewayOptions {
  // 127.0.0.1, localhost or [::1] with a port; 0 takes a free one. With `tls`, any IP address of this machine, or all
  // of them (0.0.0.0, [::]).
  std::string listen_address = "127.0.0.1:0";
  // Certificate and key, read once; with require_client_certificate and an authority, of browsers too.
  std::optional<config::v1::TlsConfig> tls = {};
  // What browsers may call this machine beside 127.0.0.1, localhost and [::1], such as "studio.example"; the first is
  // for url(). The host of listen_address when empty.
  std::vector<std::string> host_names = {};
  // The built page; see site.h. Without it, "/" says how to build it.
  std::filesystem::path page_folder = {};
  std::vector<ExposedService> services = {};
  // 64 hexadecimal digits; 32 random bytes when empty.
  std::string token = "";
  GatewayLimits limits = {};
};

// Serves on two threads of its own. Thread-safe.
class Gateway {
 public:
  // Reads the page and listens. INVALID_ARGUMENT for an address that other machines reach without TLS, for files of
  // TLS, and for services and methods that are not there; UNAVAILABLE when the address cannot be had.
  static absl::StatusOr<std::unique_ptr<Gateway>> Start(GatewayOptions options);
  // Stops.
  ~Gateway();
  Gateway(const Gateway&) = delete;
  Gateway& operator=(const Gateway&) = delete;

  // What to open in a browser, with the token: secret.
  const std::string& url() const { return url_; }
  // The same without the token, such as "http://127.0.0.1:41234/".
  const std::string& address() const { return address_; }
  int port() const { return port_; }

  // Ends streams at once, with UNAVAILABLE, and unary calls when they are answered or after drain_timeout. Returns when
  // no call is under way any more. May be called again.
  void Stop();

 private:
  class Server;
  explicit Gateway(std::unique_ptr<Server> server);

  std::string url_;
  std::string address_;
  int port_ = 0;
  std::unique_ptr<Server> server_;
};

}  // namespace flair::studio
