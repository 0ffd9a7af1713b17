// SPDX-License-Identifier: GPL-3.0-or-later
// Apart from the list of targets, so that a fuzzer holds, and counts the branches of, its own target only.
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/targets.h"

namespace flair::fuzz {

void Require(bool holds, std::string_view promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %.*s\n", static_cast<int>(promise.size()), promise.data());
  std::abort();
}

}  // namespace flair::fuzz
