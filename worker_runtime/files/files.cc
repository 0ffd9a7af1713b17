// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/files/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/message_lite.h>
#include <openssl/evp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <set>
#include <utility>
#include <vector>

namespace flair::runtime {
namespace {

absl::Status FileError(const std::string& path, const char* what) {
  const int error = errno;
  const std::string message = fmt::format("{}: {}: {}", path, what, std::strerror(error));
  return error == ENOSPC || error == EDQUOT ? absl::ResourceExhaustedError(message) : absl::UnavailableError(message);
}

absl::Status WriteAll(int file, const std::string& bytes, const std::string& path) {
  size_t written = 0;
  while (written < bytes.size()) {
    const ssize_t count = ::write(file, bytes.data() + written, bytes.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return FileError(path, "cannot write");
    written += static_cast<size_t>(count);
  }
  return absl::OkStatus();
}

// Makes a new name in a folder survive a loss of power. Some file systems refuse; then there is nothing more to do.
void FlushFolder(const std::string& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return;
  (void)::fsync(file);
  ::close(file);
}

}  // namespace

absl::Status WriteFileAtomically(const std::string& path, const std::string& bytes, Durability durability) {
  static std::atomic<int> counter = 0;
  const std::string temporary = fmt::format("{}.{}.{}.part", path, ::getpid(), counter++);
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0644);
  if (file < 0) return FileError(temporary, "cannot create");
  absl::Status status = WriteAll(file, bytes, temporary);
  const bool flush = durability == Durability::kPowerLoss;
  if (status.ok() && flush && ::fsync(file) != 0) status = FileError(temporary, "cannot flush");
  if (::close(file) != 0 && status.ok()) status = FileError(temporary, "cannot close");
  if (status.ok() && ::rename(temporary.c_str(), path.c_str()) != 0) status = FileError(path, "cannot rename to");
  if (!status.ok()) {
    ::unlink(temporary.c_str());
    return status;
  }
  if (flush) FlushFolder(std::filesystem::path(path).parent_path());
  return absl::OkStatus();
}

absl::Status FlushFiles(std::span<const std::string> paths) {
  // All are given to the disk before the first is waited for: then one commit of the file system's journal covers the
  // names and places of all, instead of one for each.
  std::vector<std::pair<int, const std::string*>> files;
  std::set<std::string> folders;
  for (const std::string& path : paths) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) continue;
    (void)::sync_file_range(file, 0, 0, SYNC_FILE_RANGE_WRITE);
    files.emplace_back(file, &path);
    folders.insert(std::filesystem::path(path).parent_path());
  }
  absl::Status status;
  for (const auto& [file, path] : files) {
    if (status.ok() && ::fsync(file) != 0) status = FileError(*path, "cannot flush");
    ::close(file);
  }
  if (!status.ok()) return status;
  for (const std::string& folder : folders) FlushFolder(folder);
  return absl::OkStatus();
}

std::error_code MakePrivateFolder(const std::string& path) {
  std::error_code error;
  const bool is_new = std::filesystem::create_directories(path, error);
  if (is_new) std::filesystem::permissions(path, std::filesystem::perms::owner_all, error);
  return error;
}

FileStamp FileStamp::Of(const std::string& path) {
  struct stat file = {};
  if (::stat(path.c_str(), &file) != 0) return {};
  return {file.st_ino, file.st_size, file.st_mtim.tv_sec, file.st_mtim.tv_nsec};
}

std::filesystem::path InstalledFolder(std::string_view name, const std::filesystem::path& in_source_tree) {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return in_source_tree;
  const std::filesystem::path installed = program.parent_path().parent_path() / "share" / "flair" / name;
  return std::filesystem::is_directory(installed, error) ? installed : in_source_tree;
}

std::string Sha256Hex(std::string_view bytes) {
  // Looked for once: to find it takes longer than to digest the bytes of a key.
  static EVP_MD* const sha256 = EVP_MD_fetch(nullptr, "SHA256", nullptr);
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  // Fails only when the library has no SHA-256 at all; going on without content addresses would corrupt the store.
  if (EVP_Digest(bytes.data(), bytes.size(), digest, &size, sha256, nullptr) != 1) std::abort();
  constexpr char kDigits[] = "0123456789abcdef";
  std::string hex;
  hex.reserve(2 * size);
  for (unsigned int i = 0; i < size; ++i) {
    hex.push_back(kDigits[digest[i] >> 4]);
    hex.push_back(kDigits[digest[i] & 15]);
  }
  return hex;
}

std::string CanonicalBytes(const google::protobuf::MessageLite& message) {
  std::string bytes;
  bytes.reserve(message.ByteSizeLong());
  google::protobuf::io::StringOutputStream stream(&bytes);
  google::protobuf::io::CodedOutputStream coded(&stream);
  coded.SetSerializationDeterministic(true);
  message.SerializeToCodedStream(&coded);
  coded.Trim();
  return bytes;
}

}  // namespace flair::runtime
