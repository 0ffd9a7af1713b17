// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "flair/v1/artifact.pb.h"

namespace flair::orchestrator {

// What was found, in one line for people: "3 zones: sleeping, storage, work".
std::string Summarize(const v1::Artifact& artifact);

}  // namespace flair::orchestrator
