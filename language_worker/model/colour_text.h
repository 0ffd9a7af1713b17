// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "flair/v1/style_sheet.pb.h"
#include "language_worker/handbook/handbook.h"

namespace flair::language {

// The colour that a model wrote as its name and value, in any order: "sage #7A8B6F", "#7A8B6F sage", "sage rgb(122,
// 139, 111)"; without a value the handbook's of that name. Nothing when it is none. Pure; any text is good input.
std::optional<v1::Colour> ReadColour(std::string_view text, const Handbook& handbook);

}  // namespace flair::language
