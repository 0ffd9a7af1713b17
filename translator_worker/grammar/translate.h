// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "flair/v1/translator_service.pb.h"

namespace flair::translator {

// Translates every sentence of a request whose catalogue is set. The request must have been validated.
v1::LayoutGraph Translate(const v1::TranslateRequest& request);

}  // namespace flair::translator
