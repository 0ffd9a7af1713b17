// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/write_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "cli/exit_code.h"
#include "fmt/format.h"
#include "worker_runtime/files/files.h"

namespace flair::cli {
namespace {

absl::Status WithDescriptor(const std::filesystem::path& path, int flags, int (*act)(int)) {
  const int file = ::open(path.c_str(), flags | O_CLOEXEC);
  if (file < 0) return CannotWrite(path, errno);
  const int error = act(file) == 0 ? 0 : errno;
  ::close(file);
  return error == 0 ? absl::OkStatus() : CannotWrite(path, error);
}

}  // namespace

absl::Status CannotWrite(const std::filesystem::path& path, int error) {
  return FileError(fmt::format("{}: cannot be written: {}", path.string(), std::strerror(error)));
}

absl::Status WriteFile(const std::filesystem::path& path, const std::string& content) {
  const absl::Status status = runtime::WriteFileAtomically(path.string(), content, runtime::Durability::kProcessCrash);
  return status.ok() ? status : FileError(std::string(status.message()));
}

absl::Status FlushFileSystem(const std::filesystem::path& path) {
  return WithDescriptor(path, O_RDONLY | O_DIRECTORY, ::syncfs);
}

absl::Status FlushFile(const std::filesystem::path& path) { return WithDescriptor(path, O_RDONLY, ::fsync); }

}  // namespace flair::cli
