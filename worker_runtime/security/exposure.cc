// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/security/exposure.h"

#include <fmt/format.h>

#include "worker_runtime/security/local_address.h"

namespace flair::runtime {
namespace {

bool Exposed(const std::string& address, const config::v1::RuntimeConfig& runtime) {
  return !address.empty() && !IsLocalAddress(address) && !runtime.allow_insecure();
}

constexpr char kElse[] =
    "or listen on 127.0.0.1, or set runtime.allow_insecure: true if only friends reach that network";

}  // namespace

std::string ExposureFault(const config::v1::RuntimeConfig& runtime, std::optional<bool> asks_for_tokens) {
  if (!Exposed(runtime.listen_address(), runtime)) return "";
  const bool knows_callers = asks_for_tokens.value_or(false) || runtime.tls().require_client_certificate();
  if (runtime.has_tls() && knows_callers) return "";
  return fmt::format("\"{}\" can be reached from other machines, {}; set runtime.tls{}, {}", runtime.listen_address(),
                     runtime.has_tls() ? "but anybody may call" : "but in plain text, which others can read and change",
                     asks_for_tokens.has_value() ? " and one of tokens_path and runtime.tls.require_client_certificate"
                                                 : " with require_client_certificate",
                     kElse);
}

std::string MetricsExposureFault(const config::v1::RuntimeConfig& runtime) {
  if (!Exposed(runtime.metrics_address(), runtime)) return "";
  return fmt::format("\"{}\" can be reached from other machines, in plain text and by anybody; remove it, {}",
                     runtime.metrics_address(), kElse);
}

}  // namespace flair::runtime
