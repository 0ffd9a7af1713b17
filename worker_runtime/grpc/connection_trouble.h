// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "absl/status/status.h"

namespace flair::runtime {

// What gRPC 1.51 says of a connection that did not come about, or of an answer that did not come, as a person would:
// what happened, at which address, and what to look at. Every other message stays as it is.
std::string InPlainWords(std::string_view message);

// Whether a call ended, as told in plain words, because the server took the connection and did not say hello in time,
// as one that is very busy may not: it has not heard of the call.
bool SaidNoHello(const absl::Status& status);

}  // namespace flair::runtime
