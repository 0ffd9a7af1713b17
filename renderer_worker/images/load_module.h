// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "renderer_worker/images/encoder_module.h"

namespace flair::renderer {

// The module that reads and writes images, loaded by the first call of the process (0.4 s) and never unloaded: beside
// the program, in ../lib or ../lib/flair of it, in $FLAIR_MODULE_DIR, or where it was built. UNAVAILABLE when it is not
// there or of another version. Thread-safe.
absl::StatusOr<const EncoderModule*> LoadImageModule();

}  // namespace flair::renderer
