// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <string>

namespace flair::runtime {

// Tells whether a file was replaced or written since. All zero when it cannot be read.
struct FileStamp {
  uint64_t inode = 0;
  int64_t size_bytes = 0;
  int64_t seconds = 0;
  int64_t nanoseconds = 0;

  static FileStamp Of(const std::string& path) {
    struct stat file = {};
    if (::stat(path.c_str(), &file) != 0) return {};
    return {file.st_ino, file.st_size, file.st_mtim.tv_sec, file.st_mtim.tv_nsec};
  }
  bool operator==(const FileStamp&) const = default;
};

}  // namespace flair::runtime
