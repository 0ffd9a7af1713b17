// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "absl/status/statusor.h"
#include "cli/output/output_folder.h"

struct archive;

namespace flair::cli {

// A tar file that is being written. FAILED_PRECONDITION when it cannot be.
class TarFile {
 public:
  static absl::StatusOr<std::unique_ptr<TarFile>> Make(const std::filesystem::path& path);
  ~TarFile();

  // Nothing but name and content decides the bytes.
  absl::Status Add(const std::string& name, const std::string& content);
  absl::Status Close();

 private:
  friend absl::StatusOr<std::string> ArchiveOf(std::span<const OutputFile> files, bool zip);

  explicit TarFile(std::filesystem::path path, bool zip = false);
  absl::Status Error() const;

  const std::filesystem::path path_;
  archive* const archive_;
};

// The bytes of a tar or a zip file with these.
absl::StatusOr<std::string> ArchiveOf(std::span<const OutputFile> files, bool zip);

}  // namespace flair::cli
