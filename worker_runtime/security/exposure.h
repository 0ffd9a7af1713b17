// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "flair/config/v1/runtime_config.pb.h"

namespace flair::runtime {

// Why a program may not serve where its config says: other machines could reach it, and it would speak plain text or
// not ask who calls. Names the fields that make it right; empty when it may. `asks_for_tokens`: its calls need a token,
// which does in place of a client certificate; nullopt for programs that know no tokens.
std::string ExposureFault(const config::v1::RuntimeConfig& runtime, std::optional<bool> asks_for_tokens);

// The same of its figures, which are always served in plain text to whoever asks.
std::string MetricsExposureFault(const config::v1::RuntimeConfig& runtime);

}  // namespace flair::runtime
