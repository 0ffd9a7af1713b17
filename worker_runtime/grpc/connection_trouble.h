// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace flair::runtime {

// What gRPC 1.51 says of a connection that did not come about, or of an answer that did not come, as a person would:
// what happened, at which address, and what to look at. Every other message stays as it is.
std::string InPlainWords(std::string_view message);

}  // namespace flair::runtime
