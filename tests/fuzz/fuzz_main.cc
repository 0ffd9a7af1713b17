// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer's entry; one program per target, named by FLAIR_FUZZ_TARGET.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  flair::fuzz::FLAIR_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
