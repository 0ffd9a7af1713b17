// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "flair/v1/worker_service.pb.h"

namespace flair::runtime {

// The package of messages and services that this program speaks; see GetWorkerResponse.protocols.
inline constexpr char kProtocol[] = "flair.v1";

// What keeps this program from talking to a worker, such as "their-optimizer speaks flair.v2, this program flair.v1";
// empty when nothing does. A worker that names no protocol speaks ours. What it says of itself is cut short and
// printable.
std::string ProtocolFault(const v1::GetWorkerResponse& worker);

}  // namespace flair::runtime
