// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/security/security.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/x509.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <memory>

#include "worker_runtime/status/status_macros.h"

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

// What comes before the last colon, out of its brackets.
std::string HostOf(std::string_view address) {
  for (const std::string_view scheme : {"dns:///", "dns:", "ipv4:", "ipv6:"}) {
    if (address.starts_with(scheme)) {
      address.remove_prefix(scheme.size());
      break;
    }
  }
  const size_t colon = address.rfind(':');
  if (colon == std::string_view::npos) return "";
  std::string host(address.substr(0, colon));
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
  std::ranges::transform(host, host.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; });
  return host;
}

constexpr unsigned char kLoopbackNet = 127;

bool Exposed(const std::string& address, bool allowed) {
  return !address.empty() && !IsLocalAddress(address) && !allowed;
}

constexpr char kElse[] =
    "or listen on 127.0.0.1, or set runtime.{}: true if only trusted machines can reach that network";

struct Deleter {
  void operator()(std::FILE* file) const { std::fclose(file); }
  void operator()(X509* certificate) const { X509_free(certificate); }
  void operator()(EVP_PKEY* key) const { EVP_PKEY_free(key); }
};
using File = std::unique_ptr<std::FILE, Deleter>;
using Certificate = std::unique_ptr<X509, Deleter>;
using Key = std::unique_ptr<EVP_PKEY, Deleter>;

// A file of a field.
struct Source {
  const std::string& field;
  const std::string& path;

  absl::Status Fault(const std::string& problem) const { return InvalidArgument("{}: {}: {}", field, path, problem); }
  absl::Status Open(File& file) const {
    file.reset(std::fopen(path.c_str(), "rb"));
    if (file == nullptr) return Fault(fmt::format("cannot be read: {}", std::strerror(errno)));
    return absl::OkStatus();
  }
};

// Says that a key has a passphrase, instead of asking a person for it.
int NoPassphrase(char*, int, int, void* asked) {
  *static_cast<bool*>(asked) = true;
  return -1;
}

std::string TimeText(const ASN1_TIME* time) {
  std::tm parts = {};
  if (ASN1_TIME_to_tm(time, &parts) != 1) return "an unreadable time";
  return absl::FormatTime(absl::RFC3339_sec, absl::FromTM(parts, absl::UTCTimeZone()), absl::UTCTimeZone());
}

absl::Status CheckPeriod(const X509* certificate, const Source& source, absl::Time now) {
  std::time_t seconds = absl::ToTimeT(now);
  if (X509_cmp_time(X509_get0_notAfter(certificate), &seconds) <= 0) {
    return source.Fault(fmt::format("the certificate expired at {}", TimeText(X509_get0_notAfter(certificate))));
  }
  if (X509_cmp_time(X509_get0_notBefore(certificate), &seconds) > 0) {
    return source.Fault(
        fmt::format("the certificate is not valid before {}", TimeText(X509_get0_notBefore(certificate))));
  }
  return absl::OkStatus();
}

// The first certificate of a file that holds nothing but certificates.
absl::Status ReadCertificates(const Source& source, Certificate& first) {
  File file;
  RETURN_IF_ERROR(source.Open(file));
  first.reset(PEM_read_X509(file.get(), nullptr, nullptr, nullptr));
  if (first == nullptr) return source.Fault("holds no certificate in PEM (\"-----BEGIN CERTIFICATE-----\")");
  Certificate next;
  do {
    next.reset(PEM_read_X509(file.get(), nullptr, nullptr, nullptr));
  } while (next != nullptr);
  // The end of the file is an error too, of its own kind.
  if (ERR_GET_REASON(ERR_peek_last_error()) == PEM_R_NO_START_LINE) return absl::OkStatus();
  return source.Fault("one of its certificates is damaged");
}

absl::Status CheckKey(const Source& source, const X509* certificate, const std::string& certificate_path) {
  File file;
  RETURN_IF_ERROR(source.Open(file));
  bool asked = false;
  const Key key(PEM_read_PrivateKey(file.get(), nullptr, &NoPassphrase, &asked));
  if (asked) return source.Fault("the key has a passphrase; expected a key without one");
  if (key == nullptr) return source.Fault("holds no private key in PEM (\"-----BEGIN PRIVATE KEY-----\")");
  if (certificate == nullptr || X509_check_private_key(certificate, key.get()) == 1) return absl::OkStatus();
  return source.Fault(fmt::format("is not the key of the certificate in {}", certificate_path));
}

absl::Status CheckFiles(const config::v1::TlsConfig& tls, absl::Time now, const TlsFieldNames& names) {
  Certificate certificate;
  if (!tls.certificate_path().empty()) {
    const Source source = {names.certificate, tls.certificate_path()};
    absl::Status status = ReadCertificates(source, certificate);
    if (status.ok()) status = CheckPeriod(certificate.get(), source, now);
    if (!status.ok()) return status;
  }
  if (!tls.key_path().empty()) {
    const Source source = {names.key, tls.key_path()};
    RETURN_IF_ERROR(CheckKey(source, certificate.get(), tls.certificate_path()));
  }
  if (tls.authority_path().empty()) return absl::OkStatus();
  Certificate authority;
  return ReadCertificates({names.authority, tls.authority_path()}, authority);
}

}  // namespace

bool IsLocalAddress(std::string_view address) {
  if (address.starts_with("unix:")) return true;
  // A list of addresses is no address.
  if (address.find_first_of(", \t\n") != std::string_view::npos || address.find('\0') != std::string_view::npos)
    return false;
  const std::string host = HostOf(address);
  if (host == "localhost") return true;
  in_addr four = {};
  if (inet_pton(AF_INET, host.c_str(), &four) == 1) return (ntohl(four.s_addr) >> 24) == kLoopbackNet;
  in6_addr six = {};
  if (inet_pton(AF_INET6, host.c_str(), &six) != 1) return false;
  return IN6_IS_ADDR_LOOPBACK(&six) || (IN6_IS_ADDR_V4MAPPED(&six) && six.s6_addr[12] == kLoopbackNet);
}

std::optional<int> PortOf(std::string_view address) {
  const size_t colon = address.rfind(':');
  if (colon == std::string_view::npos || colon == 0) return std::nullopt;
  int port = -1;
  const char* end = address.data() + address.size();
  const auto [rest, error] = std::from_chars(address.data() + colon + 1, end, port);
  if (error != std::errc() || rest != end || port < 0 || port > 65535) return std::nullopt;
  return port;
}

std::string ExposureFault(const config::v1::RuntimeConfig& runtime, std::optional<bool> asks_for_tokens) {
  if (!Exposed(runtime.listen_address(), runtime.allow_insecure())) return "";
  const bool knows_callers = asks_for_tokens.value_or(false) || runtime.tls().require_client_certificate();
  if (runtime.has_tls() && knows_callers) return "";
  return fmt::format("\"{}\" can be reached from other machines, {}; set runtime.tls{}, {}", runtime.listen_address(),
                     runtime.has_tls() ? "but anybody may call" : "but in plain text, which others can read and change",
                     asks_for_tokens.has_value() ? " and one of tokens_path and runtime.tls.require_client_certificate"
                                                 : " with require_client_certificate",
                     fmt::format(kElse, "allow_insecure"));
}

std::string MetricsExposureFault(const config::v1::RuntimeConfig& runtime) {
  const bool allowed = runtime.allow_insecure() || runtime.allow_insecure_metrics();
  if (!Exposed(runtime.metrics_address(), allowed)) return "";
  return fmt::format("\"{}\" can be reached from other machines, in plain text and by anybody; remove it, {}",
                     runtime.metrics_address(), fmt::format(kElse, "allow_insecure_metrics"));
}

absl::Status CheckTlsFiles(const config::v1::TlsConfig& tls, absl::Time now, const TlsFieldNames& names) {
  // OpenSSL remembers errors per thread: neither those of others here nor ours there.
  ERR_clear_error();
  const absl::Status status = CheckFiles(tls, now, names);
  ERR_clear_error();
  return status;
}

absl::Status CheckMetricsAddress(const std::string& address) {
  if (PortOf(address).has_value() && IsHost(std::string_view(address).substr(0, address.rfind(':')))) {
    return absl::OkStatus();
  }
  return InvalidArgument("\"{}\": expected HOST:PORT with a port in [0, 65535], such as 127.0.0.1:9090", address);
}

}  // namespace flair::runtime
