// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/output_folder.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <set>

#include "cli/exit_code.h"
#include "cli/input/artifact_file.h"
#include "fmt/format.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

namespace fs = std::filesystem;

absl::Status Cannot(const std::string& what, const fs::path& path, int error) {
  return FileError("{}: cannot {}: {}", path.string(), what, std::strerror(error));
}

fs::path Absolute(const fs::path& path) {
  fs::path absolute = fs::absolute(path).lexically_normal();
  return absolute.filename().empty() ? absolute.parent_path() : absolute;
}

// A temporary folder beside another one; removed with what is in it unless kept.
class TemporaryFolder {
 public:
  absl::Status Make(const fs::path& beside) {
    std::error_code error;
    for (fs::path p = beside.parent_path(); !fs::exists(p, error) && p.has_relative_path(); p = p.parent_path()) {
      made_parents_.push_back(p);
    }
    fs::create_directories(beside.parent_path(), error);
    if (error) return Cannot("be made", beside.parent_path(), error.value());
    std::string pattern = (beside.parent_path() / fmt::format(".{}.flair-XXXXXX", beside.filename().string())).string();
    if (mkdtemp(pattern.data()) == nullptr) return Cannot("be written", beside.parent_path(), errno);
    path_ = pattern;
    const mode_t mask = umask(0);
    umask(mask);
    chmod(path_.c_str(), 0777 & ~mask);
    return absl::OkStatus();
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
    if (keep_parents_) return;
    for (const fs::path& parent : made_parents_) fs::remove(parent, ignored);  // only when empty
  }
  const fs::path& path() const { return path_; }
  void KeepParents() { keep_parents_ = true; }

 private:
  fs::path path_;
  std::vector<fs::path> made_parents_;
  bool keep_parents_ = false;
};

// `flags` say how it is opened; errors speak of `shown`.
absl::Status Write(const fs::path& path, int flags, const std::string& content, const fs::path& shown) {
  const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
  if (file < 0) return Cannot("be written", shown, errno);
  int error = WriteAll(file, content);
  if (error == 0 && fsync(file) != 0 && errno != EINVAL) error = errno;
  if (close(file) != 0 && error == 0) error = errno;
  return error == 0 ? absl::OkStatus() : Cannot("be written", shown, error);
}

absl::Status WriteNew(const fs::path& path, const std::string& content, const fs::path& shown) {
  return Write(path, O_CREAT | O_EXCL, content, shown);
}

// A device, a pipe: written to, never replaced.
bool IsSpecial(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

bool HoldsOnly(const fs::path& folder, const std::set<std::string>& names) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (!names.contains(entry.path().filename().string())) return false;
  }
  return !error;
}

absl::Status PutInPlace(const fs::path& made, const fs::path& folder, const std::vector<OutputFile>& files) {
  std::error_code error;
  if (!fs::exists(folder, error)) {
    if (rename(made.c_str(), folder.c_str()) == 0) return absl::OkStatus();
    return Cannot("be made", folder, errno);
  }
  std::set<std::string> names;
  for (const OutputFile& file : files) names.insert(file.name);
  // The old folder goes away with the temporary one, whose name it then has.
  if (HoldsOnly(folder, names) && !fs::is_symlink(folder, error) &&
      renameat2(AT_FDCWD, made.c_str(), AT_FDCWD, folder.c_str(), RENAME_EXCHANGE) == 0) {
    return absl::OkStatus();
  }
  for (const OutputFile& file : files) {
    if (rename((made / file.name).c_str(), (folder / file.name).c_str()) != 0) {
      return Cannot("be replaced", folder / file.name, errno);
    }
  }
  return absl::OkStatus();
}

absl::Status WithDescriptor(const std::filesystem::path& path, int flags, int (*act)(int)) {
  const int file = ::open(path.c_str(), flags | O_CLOEXEC);
  if (file < 0) return CannotWrite(path, errno);
  const int error = act(file) == 0 ? 0 : errno;
  ::close(file);
  return error == 0 ? absl::OkStatus() : CannotWrite(path, error);
}

}  // namespace

int WriteAll(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t count = ::write(file, content.data(), content.size());
    if (count < 0 && errno != EINTR) return errno;
    if (count > 0) content.remove_prefix(static_cast<size_t>(count));
  }
  return 0;
}

absl::Status CheckOutputFolder(const fs::path& given, const std::vector<std::string>& names) {
  const fs::path folder = Absolute(given);
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
    return FileError("{}: is a file; --out takes a folder", folder.string());
  }
  if (fs::is_directory(folder, error)) {
    if (access(folder.c_str(), W_OK | X_OK) != 0) return Cannot("be written", folder, errno);
    const bool is_ours = ReadArtifactFile(folder / "brief.pb").ok();
    for (const std::string& name : names) {
      if (!is_ours && fs::exists(folder / name, error)) {
        return FileError("{}: holds {}, which is not Flair's; give --out another folder", folder.string(), name);
      }
    }
  }
  return TemporaryFolder().Make(folder);
}

absl::Status WriteOutputFolder(const fs::path& given, const std::vector<OutputFile>& files) {
  const fs::path folder = Absolute(given);
  TemporaryFolder temporary;
  RETURN_IF_ERROR(temporary.Make(folder));
  for (const OutputFile& file : files) {
    RETURN_IF_ERROR(WriteNew(temporary.path() / file.name, file.content, folder / file.name));
  }
  absl::Status status = PutInPlace(temporary.path(), folder, files);
  if (status.ok()) temporary.KeepParents();
  return status;
}

absl::Status CheckOutputFile(const fs::path& given) {
  if (given.empty()) return absl::OkStatus();
  const fs::path path = Absolute(given);
  std::error_code error;
  if (fs::is_directory(path, error)) return FileError("{}: is a folder", path.string());
  if (IsSpecial(path)) return access(path.c_str(), W_OK) == 0 ? absl::OkStatus() : Cannot("be written", path, errno);
  return TemporaryFolder().Make(path);
}

absl::Status WriteOutputFile(const fs::path& given, const std::string& content) {
  const fs::path path = Absolute(given);
  std::error_code error;
  if (fs::is_directory(path, error)) return FileError("{}: is a folder", path.string());
  if (IsSpecial(path)) return Write(path, 0, content, path);
  TemporaryFolder temporary;
  RETURN_IF_ERROR(temporary.Make(path));
  const fs::path made = temporary.path() / path.filename();
  RETURN_IF_ERROR(WriteNew(made, content, path));
  if (rename(made.c_str(), path.c_str()) != 0) return Cannot("be written", path, errno);
  temporary.KeepParents();
  return absl::OkStatus();
}

absl::Status CannotWrite(const std::filesystem::path& path, int error) {
  return FileError("{}: cannot be written: {}", path.string(), std::strerror(error));
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
