// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/files/installed_folder.h"

namespace flair::runtime {

std::filesystem::path InstalledFolder(std::string_view name, const std::filesystem::path& in_source_tree) {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return in_source_tree;
  const std::filesystem::path installed = program.parent_path().parent_path() / "share" / "flair" / name;
  return std::filesystem::is_directory(installed, error) ? installed : in_source_tree;
}

}  // namespace flair::runtime
