// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "flair/config/v1/runtime_config.pb.h"

namespace flair::runtime {

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
