// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "worker_runtime/files/sha256.h"

namespace flair::orchestrator {

using runtime::CanonicalBytes;
using runtime::Sha256Hex;

}  // namespace flair::orchestrator
