// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/channel.h"

#include <fmt/format.h>
#include <grpc/grpc.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/security/tls_certificate_provider.h>
#include <grpcpp/security/tls_credentials_options.h>
#include <grpcpp/support/channel_arguments.h>

#include <map>
#include <mutex>

#include "absl/time/clock.h"
#include "worker_runtime/security/security.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::runtime {
namespace {

constexpr int kConnectWithinMs = 5000;
// A server that is not heard of for so long during a call is gone. No server takes that for abuse: without data of its
// own, gRPC asks twice at most.
constexpr int kKeepaliveMs = 30000;
constexpr int kKeepaliveTimeoutMs = 20000;

absl::Status CheckAddress(const std::string& address, const ChannelOptions& options) {
  const bool unix_socket = address.starts_with("unix:") && address.size() > 5;
  if (!unix_socket && PortOf(address).value_or(0) == 0) {
    return InvalidArgument(
        "address \"{}\": expected HOST:PORT, unix:PATH or dns:///NAME:PORT with a port in [1, 65535]", address);
  }
  if (options.tls.has_value() || options.allow_insecure || IsLocalAddress(address)) return absl::OkStatus();
  return InvalidArgument(
      "address \"{}\": on another machine, and{} plain text can be read and changed in transit; use TLS "
      "(tls), or allow it "
      "(allow_insecure)",
      address, options.token.empty() ? "" : " the token in");
}

grpc::ChannelArguments Arguments(const std::string& address, const std::string& service,
                                 const ChannelOptions& options) {
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(MaxMessageBytes(options.max_message_mib));
  arguments.SetMaxSendMessageSize(MaxMessageBytes(options.max_message_mib));
  arguments.SetInt(GRPC_ARG_INITIAL_RECONNECT_BACKOFF_MS, 200);
  // Not the time between attempts but what each may take, TLS and all: across the world, to a busy machine.
  arguments.SetInt(GRPC_ARG_MIN_RECONNECT_BACKOFF_MS, kConnectWithinMs);
  arguments.SetInt(GRPC_ARG_MAX_RECONNECT_BACKOFF_MS, 2000);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIME_MS, kKeepaliveMs);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, kKeepaliveTimeoutMs);
  // Retrying is the caller's: see orchestrator/pipeline/stage_clients.h.
  arguments.SetInt(GRPC_ARG_ENABLE_RETRIES, 0);
  if (!options.server_name.empty()) arguments.SetString(GRPC_ARG_DEFAULT_AUTHORITY, options.server_name);
  if (options.only_while_serving || address.starts_with("dns:")) {
    // No timeout in here, ever: gRPC 1.51 then ends calls too early. Deadlines are set per call.
    arguments.SetServiceConfigJSON(fmt::format(
        R"({{"loadBalancingConfig":[{{"round_robin":{{}}}}],"healthCheckConfig":{{"serviceName":"{}"}}}})",
        // The whole server, which most servers speak of; of a service of ours those of others need not know.
        options.only_while_serving ? "" : service));
  }
  return arguments;
}

using grpc::experimental::FileWatcherCertificateProvider;

constexpr unsigned kLookEverySeconds = 2;

// Watches the files of `tls` on a thread of its own.
std::shared_ptr<FileWatcherCertificateProvider> Watch(const config::v1::TlsConfig& tls, bool with_authority) {
  return std::make_shared<FileWatcherCertificateProvider>(
      tls.key_path(), tls.certificate_path(), with_authority ? tls.authority_path() : "", kLookEverySeconds);
}

std::shared_ptr<grpc::ChannelCredentials> NewChannelCredentials(const config::v1::TlsConfig& tls) {
  grpc::experimental::TlsChannelCredentialsOptions options;
  const bool has_authority = !tls.authority_path().empty();
  const bool has_certificate = !tls.certificate_path().empty();
  if (has_authority || has_certificate) options.set_certificate_provider(Watch(tls, has_authority));
  if (has_authority) options.watch_root_certs();
  if (has_certificate) options.watch_identity_key_cert_pairs();
  return grpc::experimental::TlsCredentials(options);
}

using grpc::experimental::InterceptionHookPoints;

class Sender final : public grpc::experimental::Interceptor {
 public:
  explicit Sender(const std::string& header) : header_(header) {}
  void Intercept(grpc::experimental::InterceptorBatchMethods* methods) override {
    if (methods->QueryInterceptionHookPoint(InterceptionHookPoints::PRE_SEND_INITIAL_METADATA)) {
      methods->GetSendInitialMetadata()->emplace("authorization", header_);
    }
    methods->Proceed();
  }

 private:
  const std::string& header_;
};

class Factory final : public grpc::experimental::ClientInterceptorFactoryInterface {
 public:
  explicit Factory(const std::string& token) : header_("Bearer " + token) {}
  grpc::experimental::Interceptor* CreateClientInterceptor(grpc::experimental::ClientRpcInfo*) override {
    return new Sender(header_);
  }

 private:
  const std::string header_;
};

}  // namespace

int MaxMessageBytes(int max_message_mib) { return (max_message_mib > 0 ? max_message_mib : 32) * 1024 * 1024; }

ChannelOptions ChannelOptionsOf(const config::v1::RuntimeConfig& runtime) {
  ChannelOptions options;
  options.max_message_mib = runtime.max_message_mib();
  options.allow_insecure = runtime.allow_insecure();
  if (runtime.has_tls()) options.tls = runtime.tls();
  return options;
}

absl::StatusOr<std::shared_ptr<grpc::Channel>> MakeChannel(const std::string& address, const std::string& service,
                                                           const ChannelOptions& options) {
  RETURN_IF_ERROR(CheckAddress(address, options));
  // Otherwise gRPC shuts itself down with the last channel, and version 1.51 then waits ten seconds for a thread that
  // it started when a large message, such as one that is refused, did not fit into the socket at once.
  [[maybe_unused]] static const bool never_shut_down = (grpc_init(), true);
  std::shared_ptr<grpc::ChannelCredentials> credentials = grpc::InsecureChannelCredentials();
  if (options.tls.has_value()) {
    ASSIGN_OR_RETURN(credentials, MakeChannelCredentials(*options.tls));
  }
  const grpc::ChannelArguments arguments = Arguments(address, service, options);
  if (options.token.empty()) return grpc::CreateCustomChannel(address, credentials, arguments);
  return grpc::experimental::CreateCustomChannelWithInterceptors(address, credentials, arguments,
                                                                 SendBearerToken(options.token));
}

absl::StatusOr<std::shared_ptr<grpc::ServerCredentials>> MakeServerCredentials(const config::v1::TlsConfig& tls) {
  RETURN_IF_ERROR(CheckTlsFiles(tls, absl::Now()));
  grpc::experimental::TlsServerCredentialsOptions options(Watch(tls, tls.require_client_certificate()));
  options.watch_identity_key_cert_pairs();
  if (tls.require_client_certificate()) {
    options.watch_root_certs();
    options.set_cert_request_type(GRPC_SSL_REQUEST_AND_REQUIRE_CLIENT_CERTIFICATE_AND_VERIFY);
  }
  return grpc::experimental::TlsServerCredentials(options);
}

absl::StatusOr<std::shared_ptr<grpc::ChannelCredentials>> MakeChannelCredentials(const config::v1::TlsConfig& tls) {
  // A program has many channels of one config; each would watch the same files.
  static std::mutex mutex;
  static auto& known = *new std::map<std::string, std::weak_ptr<grpc::ChannelCredentials>>();
  const std::lock_guard lock(mutex);
  std::weak_ptr<grpc::ChannelCredentials>& made = known[tls.SerializeAsString()];
  if (std::shared_ptr<grpc::ChannelCredentials> credentials = made.lock()) return credentials;
  RETURN_IF_ERROR(CheckTlsFiles(tls, absl::Now()));
  std::shared_ptr<grpc::ChannelCredentials> credentials = NewChannelCredentials(tls);
  made = credentials;
  return credentials;
}

std::vector<std::unique_ptr<grpc::experimental::ClientInterceptorFactoryInterface>> SendBearerToken(
    const std::string& token) {
  std::vector<std::unique_ptr<grpc::experimental::ClientInterceptorFactoryInterface>> factories;
  factories.push_back(std::make_unique<Factory>(token));
  return factories;
}

}  // namespace flair::runtime
