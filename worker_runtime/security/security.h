// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "flair/config/v1/runtime_config.pb.h"

namespace flair::runtime {

// Whether only this machine can be meant by an address to serve on or to call: "HOST:PORT" with HOST in 127.0.0.0/8,
// ::1 or "localhost", also after "dns:///", "ipv4:" or "ipv6:", or "unix:PATH". False for anything else, also for what
// is no address.
bool IsLocalAddress(std::string_view address);

// The port at the end of "HOST:PORT", in [0, 65535]; nothing when there is none, or no HOST before it.
std::optional<int> PortOf(std::string_view address);

// Why a program may not serve where its config says: other machines could reach it, and it would speak plain text or
// not ask who calls. Names the fields that make it right; empty when it may. `asks_for_tokens`: its calls need a token,
// which does in place of a client certificate; nullopt for programs that know no tokens.
std::string ExposureFault(const config::v1::RuntimeConfig& runtime, std::optional<bool> asks_for_tokens);

// The same of its figures, which are always served in plain text to whoever asks.
std::string MetricsExposureFault(const config::v1::RuntimeConfig& runtime);

// INVALID_ARGUMENT unless `address` is HOST:PORT with a port in [0, 65535]. HOST is a name, an IPv4 address, or an IPv6
// one in brackets.
absl::Status CheckMetricsAddress(const std::string& address);

// What the fields are called, in messages.
struct TlsFieldNames {
  std::string certificate = "runtime.tls.certificate_path";
  std::string key = "runtime.tls.key_path";
  std::string authority = "runtime.tls.authority_path";
};

// Looks at the files of `tls` as whoever uses them will: INVALID_ARGUMENT names the field, the file and what is wrong
// with it. Certificates and keys must be PEM, the key without a passphrase and that of the certificate, which must be
// valid at `now`. Empty paths are left out.
absl::Status CheckTlsFiles(const config::v1::TlsConfig& tls, absl::Time now, const TlsFieldNames& names = {});

}  // namespace flair::runtime
