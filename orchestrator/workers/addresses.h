// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"

namespace flair::orchestrator {

// Where a stage's workers are, as its setting says: addresses with commas between.
struct StageAddresses {
  // "HOST:PORT" and "unix:PATH": a worker each.
  std::vector<std::string> workers;
  // Of "dns:///NAME:PORT": a worker at every address of the name.
  struct Name {
    std::string host;
    int port = 0;
  };
  std::vector<Name> names;
};

// INVALID_ARGUMENT names the part that has no such form.
absl::StatusOr<StageAddresses> ParseStageAddresses(const std::string& text);

// The addresses of a name, numeric: "10.0.0.7" or "fd00::7". UNAVAILABLE says why there are none. A function so that
// tests need no name server. May take seconds.
using Lookup = std::function<absl::StatusOr<std::vector<std::string>>(const std::string& host)>;

// Asks the system (getaddrinfo).
absl::StatusOr<std::vector<std::string>> LookUpHost(const std::string& host);

// "10.0.0.7:50053" or "[fd00::7]:50053".
std::string JoinHostPort(const std::string& host, int port);

}  // namespace flair::orchestrator
