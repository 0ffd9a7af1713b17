// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/local_artifacts.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>

#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// Up to some 100 kB a row is written and read sooner than a file is opened.
constexpr size_t kSmallBytes = 64 * 1024;

constexpr std::string_view kArtifactSchema[] = {R"sql(
-- Rows go where the last one went, and only the index of the ids is written at random.
CREATE TABLE artifacts (
  id TEXT NOT NULL UNIQUE,
  stored_after INTEGER NOT NULL,  -- the mark that was the last one when it was last stored
  bytes BLOB NOT NULL
);
-- One row.
CREATE TABLE marks (
  last INTEGER NOT NULL,
  flush_count INTEGER NOT NULL
);
INSERT INTO marks VALUES (0, 0);
)sql"};

// Nothing when there is no such file.
std::optional<std::string> ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return std::nullopt;
  std::string bytes(static_cast<size_t>(std::max<std::streamoff>(0, file.tellg())), '\0');
  file.seekg(0);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<size_t>(file.gcount()));
  return bytes;
}

// When the file was last stored, nanoseconds since 1970.
int64_t TimeOf(const struct stat& info) { return int64_t{info.st_mtim.tv_sec} * 1'000'000'000 + info.st_mtim.tv_nsec; }

}  // namespace

absl::StatusOr<std::unique_ptr<LocalArtifacts>> LocalArtifacts::Open(const std::string& folder) {
  RETURN_IF_ERROR(ArtifactFiles::MakeFolder(folder));
  ASSIGN_OR_RETURN(auto rows, Database::Open(folder + "/small.db", kArtifactSchema));
  return std::unique_ptr<LocalArtifacts>(new LocalArtifacts(folder, std::move(rows)));
}

absl::Status LocalArtifacts::PutAll(std::span<const SealedArtifact> artifacts) {
  std::vector<const SealedArtifact*> small;
  for (const SealedArtifact& artifact : artifacts) {
    if (artifact.bytes.size() <= kSmallBytes) {
      small.push_back(&artifact);
    } else {
      RETURN_IF_ERROR(files_.PutAll(std::span(&artifact, 1)));
    }
  }
  if (small.empty()) return absl::OkStatus();
  ASSIGN_OR_RETURN(Transaction transaction, Transaction::Begin(*rows_));
  for (const SealedArtifact* artifact : small) {
    // Bytes that were damaged are repaired by this.
    RETURN_IF_ERROR(
        rows_->Run("INSERT INTO artifacts VALUES (?, (SELECT last FROM marks), ?) ON CONFLICT (id) DO UPDATE SET "
                   "stored_after = excluded.stored_after, bytes = excluded.bytes",
                   artifact->ref.id(), Blob{artifact->bytes}));
  }
  return transaction.Commit();
}

absl::StatusOr<v1::Artifact> LocalArtifacts::Get(const std::string& id) {
  // Nothing that was stored has no bytes.
  ASSIGN_OR_RETURN(const std::string bytes, rows_->FirstText("SELECT bytes FROM artifacts WHERE id = ?", id));
  return bytes.empty() ? files_.Get(id) : ParseArtifact(bytes, id, "small.db: artifact " + id);
}

absl::Status LocalArtifacts::Flush(std::span<const v1::ArtifactRef> artifacts) {
  RETURN_IF_ERROR(files_.Flush(artifacts));
  // A commit that is flushed takes all earlier ones to the disk with it.
  ASSIGN_OR_RETURN(Transaction transaction, Transaction::Begin(*rows_, Transaction::Durability::kPowerLoss));
  RETURN_IF_ERROR(rows_->Run("UPDATE marks SET flush_count = flush_count + 1"));
  return transaction.Commit();
}

absl::StatusOr<int64_t> LocalArtifacts::Mark() {
  ASSIGN_OR_RETURN(const int64_t mark, files_.Mark());
  RETURN_IF_ERROR(rows_->Run("UPDATE marks SET last = max(last, ?)", mark));
  return mark;
}

absl::StatusOr<int64_t> LocalArtifacts::Delete(std::span<const std::string> ids, int64_t mark) {
  int64_t deleted_count = 0;
  for (const std::string& id : ids) {
    ASSIGN_OR_RETURN(const int64_t files, files_.Delete(std::span(&id, 1), mark));
    ASSIGN_OR_RETURN(const int64_t rows,
                     rows_->RunAndCount("DELETE FROM artifacts WHERE id = ? AND stored_after < ?", id, mark));
    if (files > 0 || rows > 0) ++deleted_count;
  }
  return deleted_count;
}

absl::StatusOr<std::vector<std::string>> LocalArtifacts::FindIds(const std::string& prefix) {
  // Ids are digits up to f.
  ASSIGN_OR_RETURN(auto ids, rows_->Texts("SELECT id FROM artifacts WHERE id >= ? AND id < ?", prefix, prefix + "g"));
  std::ranges::copy(files_.FindIds(prefix), std::back_inserter(ids));
  std::ranges::sort(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

absl::StatusOr<std::unique_ptr<ArtifactStore>> ArtifactFiles::Open(const std::string& folder) {
  RETURN_IF_ERROR(MakeFolder(folder));
  return std::make_unique<ArtifactFiles>(folder);
}

absl::Status ArtifactFiles::MakeFolder(const std::string& folder) {
  const std::error_code error = runtime::MakePrivateFolder(folder);
  if (error || ::access(folder.c_str(), W_OK) != 0) {
    return Unavailable("the folder for artifacts, {}, cannot be {}: {}", folder, error ? "made" : "written to",
                       error ? error.message() : std::strerror(errno));
  }
  return absl::OkStatus();
}

std::string ArtifactFiles::PathOf(const std::string& id) const {
  return fmt::format("{}/{}/{}.pb", folder_, id.substr(0, 2), id);
}

absl::Status ArtifactFiles::PutAll(std::span<const SealedArtifact> artifacts) {
  for (const SealedArtifact& artifact : artifacts) RETURN_IF_ERROR(PutOne(artifact));
  return absl::OkStatus();
}

absl::Status ArtifactFiles::PutOne(const SealedArtifact& artifact) const {
  const std::string path = PathOf(artifact.ref.id());
  // Who deletes it, since nobody had it, sees that it is wanted again. It may be gone just now.
  if (ReadFile(path) == artifact.bytes && ::utimensat(AT_FDCWD, path.c_str(), nullptr, 0) == 0) return absl::OkStatus();
  const std::string folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (!std::filesystem::exists(folder, error)) std::filesystem::create_directories(folder, error);
  if (error) return Unavailable("{}: cannot create its folder: {}", path, error.message());
  return runtime::WriteFileAtomically(path, artifact.bytes, runtime::Durability::kProcessCrash);
}

absl::Status ArtifactFiles::Flush(std::span<const v1::ArtifactRef> artifacts) {
  std::vector<std::string> paths;
  for (const v1::ArtifactRef& artifact : artifacts) {
    if (IsArtifactId(artifact.id())) paths.push_back(PathOf(artifact.id()));
  }
  return runtime::FlushFiles(paths);
}

absl::StatusOr<int64_t> ArtifactFiles::Mark() {
  std::string path = folder_ + "/mark-XXXXXX";
  const int file = ::mkstemp(path.data());
  if (file < 0) return Unavailable("{}: cannot be created: {}", path, std::strerror(errno));
  ::unlink(path.c_str());
  // The clock of a file system stands still for some milliseconds; of two files with one time nobody knows the order.
  struct stat info = {};
  ::fstat(file, &info);
  const int64_t mark = TimeOf(info);
  while (::futimens(file, nullptr) == 0 && ::fstat(file, &info) == 0 && TimeOf(info) == mark) ::usleep(500);
  ::close(file);
  return mark;
}

absl::StatusOr<int64_t> ArtifactFiles::Delete(std::span<const std::string> ids, int64_t mark) {
  int64_t deleted = 0;
  for (const std::string& id : ids) {
    if (!IsArtifactId(id)) continue;
    const std::string path = PathOf(id);
    struct stat info = {};
    if (::stat(path.c_str(), &info) == 0 && TimeOf(info) > mark) continue;
    if (::unlink(path.c_str()) == 0) {
      ++deleted;
    } else if (errno != ENOENT) {
      return Unavailable("{}: cannot be deleted: {}", path, std::strerror(errno));
    }
  }
  return deleted;
}

absl::StatusOr<v1::Artifact> ArtifactFiles::Get(const std::string& id) {
  if (!IsArtifactId(id)) {
    return InvalidArgument("artifact_id: \"{}\" is not an id; expected 64 characters 0-9 and a-f", id.substr(0, 80));
  }
  const std::string path = PathOf(id);
  const std::optional<std::string> bytes = ReadFile(path);
  if (!bytes.has_value()) return NotFound("artifact {}: not in this store", id);
  return ParseArtifact(*bytes, id, path);
}

std::vector<std::string> ArtifactFiles::FindIds(const std::string& prefix) const {
  std::vector<std::string> ids;
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::path(PathOf(prefix)).parent_path();
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string id = entry.path().stem().string();
    if (IsArtifactId(id) && id.starts_with(prefix)) ids.push_back(id);
  }
  return ids;
}

}  // namespace flair::orchestrator
