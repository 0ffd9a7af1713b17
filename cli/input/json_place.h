// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "cli/input/field_path.h"

namespace flair::cli {

// Where in a JSON text the field begins, as a byte offset; of the innermost part on the way to it that is there. Field
// names may be those of the .proto files or in camel case. Looks once through what lies before; 0 for what is no JSON.
size_t FindJsonField(std::string_view json, const std::vector<PathStep>& path);

// The line of a byte, from 1 on.
int LineAt(std::string_view text, size_t offset);

}  // namespace flair::cli
