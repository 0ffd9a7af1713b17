// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "renderer_worker/images/encoder_module.h"

namespace flair::renderer {

// EncoderModule::decode. Within the module only.
bool Decode(const DecoderRequest& request, DecoderStart start, DecoderRow row, EncoderSink error, void* context);

}  // namespace flair::renderer
