// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace flair::runtime {

// Where a program's data files are: share/flair/NAME beside the program's own folder when it is installed, else the
// folder of the source tree.
std::filesystem::path InstalledFolder(std::string_view name, const std::filesystem::path& in_source_tree);

}  // namespace flair::runtime
