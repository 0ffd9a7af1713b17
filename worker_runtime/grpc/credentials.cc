// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/credentials.h"

#include <grpcpp/security/tls_certificate_provider.h>
#include <grpcpp/security/tls_credentials_options.h>

#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "absl/time/clock.h"
#include "worker_runtime/security/security.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::runtime {
namespace {

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

}  // namespace

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

namespace {

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

std::vector<std::unique_ptr<grpc::experimental::ClientInterceptorFactoryInterface>> SendBearerToken(
    const std::string& token) {
  std::vector<std::unique_ptr<grpc::experimental::ClientInterceptorFactoryInterface>> factories;
  factories.push_back(std::make_unique<Factory>(token));
  return factories;
}

}  // namespace flair::runtime
