// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/design_folders.h"

#include <algorithm>

#include "cli/exit_code.h"
#include "fmt/format.h"

namespace flair::cli {

namespace fs = std::filesystem;

absl::StatusOr<std::vector<fs::path>> FindFoldersWith(const fs::path& root, const std::string& name, size_t most) {
  std::error_code error;
  if (!fs::exists(root, error) && !error) {
    return absl::NotFoundError(fmt::format("{}: no such folder; give one of designs", root.string()));
  }
  if (!fs::is_directory(root, error)) {
    return FileError(fmt::format("{}: is no folder; give one of designs", root.string()));
  }
  std::vector<fs::path> found;
  if (fs::is_regular_file(root / name, error)) found.push_back(root);
  error.clear();
  fs::recursive_directory_iterator entry(root, fs::directory_options::skip_permission_denied, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_directory(ignored) && fs::is_regular_file(entry->path() / name, ignored))
      found.push_back(entry->path());
    if (found.size() > most) break;
  }
  if (error) return FileError(fmt::format("{}: cannot be listed: {}", root.string(), error.message()));
  if (found.empty()) return absl::NotFoundError(fmt::format("{}: no folder in it holds a {}", root.string(), name));
  if (found.size() > most) {
    return absl::InvalidArgumentError(
        fmt::format("{}: holds more than {} designs; give a part of them", root.string(), most));
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace flair::cli
