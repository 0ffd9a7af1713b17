// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/batch_input.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "absl/cleanup/cleanup.h"
#include "absl/strings/escaping.h"
#include "cli/exit_code.h"
#include "cli/input/artifact_file.h"
#include "cli/output/output_folder.h"
#include "cli/progress/progress.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

constexpr size_t kReadAtOnce = 1u << 20;

absl::Status Cannot(const char* what, const std::string& path) {
  return FileError("{}: cannot be {}: {}", path, what, std::strerror(errno));
}

// SHA-256 of what comes piece by piece.
class StreamDigest {
 public:
  StreamDigest() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
    // Fails only when the library has no SHA-256 at all.
    if (context_ == nullptr || EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) != 1) std::abort();
  }
  void Add(const std::string& bytes) {
    if (EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()) != 1) std::abort();
  }
  std::string Hex() {
    std::string digest(32, '\0');
    if (EVP_DigestFinal_ex(context_.get(), reinterpret_cast<unsigned char*>(digest.data()), nullptr) != 1) std::abort();
    return absl::BytesToHexString(digest);
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

absl::Status CheckKind(const std::string& name, const std::string& beginning) {
  std::string kind = ForeignKind(beginning);
  if (kind.starts_with("compressed")) kind += ", which zcat, zstdcat or xzcat FILE | flair batch - --out DIR unpacks";
  if (kind.empty() || kind == "text") return absl::OkStatus();
  return InvalidArgument("{}: is {}; expected text with one brief per line", name, kind);
}

// Reads the file to its end, and copies it to `copy` when there is one (>= 0).
absl::Status Digest(int file, const std::string& name, int copy, runtime::Cancellation& stop, BatchInput& input) {
  const SlowNote note("reading " + name);
  StreamDigest digest;
  std::string bytes;
  while (!stop.cancelled()) {
    bytes.resize(kReadAtOnce);
    const ssize_t count = ::read(file, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return Cannot("read", name);
    if (count == 0) {
      input.sha256 = digest.Hex();
      if (input.size_bytes > 0) return absl::OkStatus();
      return InvalidArgument("{}: is empty; expected one brief per line", name);
    }
    bytes.resize(static_cast<size_t>(count));
    if (input.size_bytes == 0) RETURN_IF_ERROR(CheckKind(name, bytes));
    digest.Add(bytes);
    input.size_bytes += count;
    if (copy >= 0 && WriteAll(copy, bytes) != 0) return Cannot("written", input.path.string());
  }
  return absl::CancelledError(fmt::format("{}: interrupted while reading; nothing was submitted", name));
}

constexpr size_t kShownOfTooLong = 1000;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

absl::Status CannotRead(const std::filesystem::path& path) {
  return FileError("{}: cannot be read: {}", path.string(), std::strerror(errno));
}

struct TextState {
  const char* name;
  std::string BatchPlace::*field;
};
constexpr std::array<TextState, 8> kTextStates = {{{"batch_id", &BatchPlace::batch_id},
                                                   {"label", &BatchPlace::label},
                                                   {"orchestrator", &BatchPlace::orchestrator},
                                                   {"store", &BatchPlace::store},
                                                   {"engine", &BatchPlace::engine},
                                                   {"queue", &BatchPlace::queue},
                                                   {"artifacts", &BatchPlace::artifacts},
                                                   {"kept", &BatchPlace::kept}}};
constexpr char kShardSize[] = "shard_size";

absl::StatusOr<BatchPlace> Read(ResultsFile& results) {
  BatchPlace place;
  for (const TextState& state : kTextStates) {
    ASSIGN_OR_RETURN(std::string value, results.State(state.name));
    place.*state.field = std::move(value);
  }
  ASSIGN_OR_RETURN(const int64_t size, results.IntState(kShardSize));
  place.shard_size = static_cast<int>(size);
  return place;
}

}  // namespace

absl::StatusOr<BatchInput> OpenBatchInput(const std::string& given, const std::filesystem::path& copy,
                                          runtime::Cancellation& stop) {
  const bool standard = given == "-";
  const std::string name = standard ? "standard input" : given;
  const int file = standard ? STDIN_FILENO : ::open(given.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0 && errno == ENOENT) {
    return NotFound("{}: no such file; expected a file with one brief per line, or -", given);
  }
  struct stat status = {};
  if (file < 0 || ::fstat(file, &status) != 0) return Cannot("read", name);
  const absl::Cleanup close = [file] {
    if (file > STDERR_FILENO) ::close(file);
  };
  if (S_ISDIR(status.st_mode)) return FileError("{}: is a folder; expected a file of briefs", given);
  BatchInput input;
  input.name = standard ? "" : std::filesystem::path(given).filename().string();
  absl::Status read;
  if (S_ISREG(status.st_mode) && !standard) {
    input.path = std::filesystem::absolute(given);
    read = Digest(file, name, -1, stop, input);
  } else {
    input.path = std::filesystem::absolute(copy);
    std::error_code error;
    std::filesystem::create_directories(input.path.parent_path(), error);
    const int made = ::open(input.path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (made < 0) return Cannot("written", input.path.string());
    read = Digest(file, name, made, stop, input);
    ::close(made);
  }
  if (!read.ok()) return read;
  return input;
}

LineReader::LineReader(std::filesystem::path path, int64_t offset, int64_t number)
    : path_(std::move(path)), file_(path_, std::ios::binary), offset_(offset), number_(number) {
  // The longest line and a zero behind it.
  buffer_.resize(kLongestLine + 1);
}

absl::StatusOr<std::unique_ptr<LineReader>> LineReader::Open(const std::filesystem::path& path, int64_t offset,
                                                             int64_t number) {
  errno = 0;
  std::unique_ptr<LineReader> reader(new LineReader(path, offset, number));
  if (errno == ENOENT) return NotFound("{}: no such file", path.string());
  reader->file_.seekg(offset);
  if (reader->file_.fail()) return CannotRead(path);
  return reader;
}

absl::StatusOr<bool> LineReader::Next(Line& line) {
  file_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  int64_t taken = file_.gcount();
  if (file_.bad()) return CannotRead(path_);
  if (taken == 0 && file_.eof()) return false;
  line = Line();
  line.number = number_++;
  line.text = std::string_view(buffer_).substr(0, static_cast<size_t>(file_.good() ? taken - 1 : taken));
  if (file_.fail()) {
    line.too_long = true;
    line.text = line.text.substr(0, kShownOfTooLong);
    file_.clear();
    file_.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    taken += file_.gcount();
  }
  offset_ += taken;
  line.end_offset = offset_;
  if (line.text.ends_with('\r')) line.text.remove_suffix(1);
  if (line.number == 1 && line.text.starts_with(kByteOrderMark)) line.text.remove_prefix(kByteOrderMark.size());
  return true;
}

std::filesystem::path ResultsPath(const std::filesystem::path& folder) { return folder / "results.db"; }

bool BatchFolder::IsAt(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::exists(ResultsPath(path), error);
}

absl::StatusOr<BatchPlace> BatchFolder::ReadPlace(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(const std::unique_ptr<ResultsFile> results, ResultsFile::OpenToRead(ResultsPath(path)));
  absl::StatusOr<BatchPlace> place = Read(*results);
  if (!place.ok() || !place->batch_id.empty()) return place;
  return NotFound("{}: its batch was never created; give the file of briefs again: flair batch FILE --out {}",
                  path.string(), path.string());
}

absl::StatusOr<std::unique_ptr<BatchFolder>> BatchFolder::Hold(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::exists(path, error) && !std::filesystem::is_directory(path, error)) {
    return FileError("{}: is a file; --out takes a folder", path.string());
  }
  std::filesystem::create_directories(path, error);
  if (error) return FileError("{}: cannot be created: {}", path.string(), error.message());
  for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(path, error)) {
    if (entry.is_symlink(error)) {
      return FileError("{}: is a symbolic link; nothing is written through one: remove it, or link --out itself",
                       entry.path().string());
    }
  }
  const std::filesystem::path lock_path = path / ".lock";
  const int lock = ::open(lock_path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock < 0) return FileError("{}: cannot be written: {}", path.string(), std::strerror(errno));
  std::unique_ptr<BatchFolder> folder(new BatchFolder(path, lock));
  if (::flock(lock, LOCK_EX | LOCK_NB) != 0) {
    return FileError("{}: another flair batch is collecting into it; let it end, or stop it first", path.string());
  }
  ASSIGN_OR_RETURN(folder->results_, ResultsFile::Open(ResultsPath(path)));
  return folder;
}

BatchFolder::~BatchFolder() { ::close(lock_); }

absl::StatusOr<BatchPlace> BatchFolder::Place() { return Read(*results_); }

absl::Status BatchFolder::SetPlace(const BatchPlace& place) {
  return results_->Change([&]() -> absl::Status {
    for (const TextState& state : kTextStates) RETURN_IF_ERROR(results_->SetState(state.name, place.*state.field));
    return results_->SetState(kShardSize, int64_t{place.shard_size});
  });
}

}  // namespace flair::cli
