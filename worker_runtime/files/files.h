// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are written whole or not at all, where installed ones are, and digests. Thread-safe.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include "absl/status/status.h"

namespace google::protobuf {
class MessageLite;
}  // namespace google::protobuf

namespace flair::runtime {

// What a written file survives. What is not flushed is cheap; after a loss of power it may be there without its
// content.
enum class Durability { kProcessCrash, kPowerLoss };

// Writes the file whole or not at all, also when the process is killed or, flushed, the power fails: a temporary file
// beside it is written and renamed. RESOURCE_EXHAUSTED when the disk is full, else UNAVAILABLE, naming the path. Its
// folder must exist.
absl::Status WriteFileAtomically(const std::string& path, const std::string& bytes,
                                 Durability durability = Durability::kPowerLoss);

// Makes files survive a loss of power, all with as few waits for the disk as it allows. Files that are gone are left
// out. Errors as WriteFileAtomically.
absl::Status FlushFiles(std::span<const std::string> paths);

// Makes a folder that only its owner may enter, with those above it as usual. One that is there stays as it is.
std::error_code MakePrivateFolder(const std::string& path);

// Tells whether a file was replaced or written since. All zero when it cannot be read.
struct FileStamp {
  uint64_t inode = 0;
  int64_t size_bytes = 0;
  int64_t seconds = 0;
  int64_t nanoseconds = 0;

  static FileStamp Of(const std::string& path);
  bool operator==(const FileStamp&) const = default;
};

// Where a program's data files are: share/flair/NAME beside the program's own folder when it is installed, else the
// folder of the source tree.
std::filesystem::path InstalledFolder(std::string_view name, const std::filesystem::path& in_source_tree);

// SHA-256 in lower-case hex, 64 characters.
std::string Sha256Hex(std::string_view bytes);

// The bytes of a message, the same in every program: known fields in number order, no map in any of our messages.
std::string CanonicalBytes(const google::protobuf::MessageLite& message);

}  // namespace flair::runtime
