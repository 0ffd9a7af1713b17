// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "absl/status/statusor.h"

namespace flair::cli::mcp {

// One folder that may be written to, and nothing outside of it: paths are walked folder by folder, and no link is
// followed, whoever puts one there meanwhile. Thread-safe.
class RootFolder {
 public:
  // FAILED_PRECONDITION when it is not there or cannot be entered.
  static absl::StatusOr<RootFolder> Open(const std::filesystem::path& folder);
  RootFolder(RootFolder&& other) noexcept;
  ~RootFolder();

  struct Replacing {
    // Whether any file may be replaced.
    bool any = false;
    // Whether one of this content may be replaced all the same.
    std::function<bool(const std::string& name, const std::string& content)> ours;
  };
  // Writes a file, whole or not at all, and makes the folders above it. Returns its absolute path. INVALID_ARGUMENT for
  // a path that leaves the folder or meets a link, ALREADY_EXISTS for a file that may not be replaced,
  // FAILED_PRECONDITION when it cannot be written.
  absl::StatusOr<std::string> Write(const std::string& path, const std::string& content,
                                    const Replacing& replacing) const;

  const std::filesystem::path& path() const { return path_; }

 private:
  RootFolder(std::filesystem::path path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

  std::filesystem::path path_;
  int descriptor_;
};

}  // namespace flair::cli::mcp
