// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/metrics/metrics_endpoint.h"

#include <fmt/format.h>
#include <prometheus/text_serializer.h>

#include <charconv>
#include <utility>

namespace flair::runtime {
namespace {

bool IsHost(std::string_view host) {
  if (host.starts_with("[") && host.ends_with("]") && host.size() > 2) {
    host = host.substr(1, host.size() - 2);
    return host.find_first_not_of("0123456789abcdefABCDEF:.") == std::string_view::npos;
  }
  return !host.empty() && host.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._") ==
                              std::string_view::npos;
}

}  // namespace

absl::Status CheckMetricsAddress(const std::string& address) {
  const size_t colon = address.rfind(':');
  int port = -1;
  if (colon != std::string::npos && IsHost(std::string_view(address).substr(0, colon))) {
    const char* end = address.data() + address.size();
    const auto [rest, error] = std::from_chars(address.data() + colon + 1, end, port);
    if (error == std::errc() && rest == end && port >= 0 && port <= 65535) return absl::OkStatus();
  }
  return absl::InvalidArgumentError(
      fmt::format("\"{}\": expected HOST:PORT with a port in [0, 65535], such as 127.0.0.1:9090", address));
}

MetricsEndpoint::MetricsEndpoint(std::unique_ptr<OnePageServer> server, std::string address)
    : server_(std::move(server)), address_(std::move(address)) {}

MetricsEndpoint::~MetricsEndpoint() = default;

absl::StatusOr<std::unique_ptr<MetricsEndpoint>> MetricsEndpoint::Start(const std::string& address,
                                                                        const PrometheusMetrics& metrics,
                                                                        absl::Duration patience) {
  if (const absl::Status status = CheckMetricsAddress(address); !status.ok()) {
    return absl::InvalidArgumentError("metrics_address " + std::string(status.message()));
  }
  const size_t colon = address.rfind(':');
  std::string host = address.substr(0, colon);
  if (host.starts_with("[")) host = host.substr(1, host.size() - 2);
  auto server = OnePageServer::Start(host, address.substr(colon + 1),
                                     {"/metrics", "text/plain; version=0.0.4; charset=utf-8",
                                      [&metrics] { return prometheus::TextSerializer().Serialize(metrics.Collect()); }},
                                     patience);
  if (server == nullptr) {
    return absl::UnavailableError(fmt::format(
        "metrics_address {}: cannot listen there: the address is in use, not of this machine, or not permitted",
        address));
  }
  std::string bound = fmt::format("{}:{}", address.substr(0, colon), server->port());
  return std::unique_ptr<MetricsEndpoint>(new MetricsEndpoint(std::move(server), std::move(bound)));
}

}  // namespace flair::runtime
