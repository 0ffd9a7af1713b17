// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/batch_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "cli/exit_code.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

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

std::filesystem::path ResultsPath(const std::filesystem::path& folder) { return folder / "results.db"; }

bool BatchFolder::IsAt(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::exists(ResultsPath(path), error);
}

absl::StatusOr<BatchPlace> BatchFolder::ReadPlace(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(const std::unique_ptr<ResultsFile> results, ResultsFile::OpenToRead(ResultsPath(path)));
  absl::StatusOr<BatchPlace> place = Read(*results);
  if (!place.ok() || !place->batch_id.empty()) return place;
  return absl::NotFoundError(
      fmt::format("{}: its batch was never created; give the file of briefs again: flair batch FILE --out {}",
                  path.string(), path.string()));
}

absl::StatusOr<std::unique_ptr<BatchFolder>> BatchFolder::Hold(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::exists(path, error) && !std::filesystem::is_directory(path, error)) {
    return FileError(fmt::format("{}: is a file; --out takes a folder", path.string()));
  }
  std::filesystem::create_directories(path, error);
  if (error) return FileError(fmt::format("{}: cannot be created: {}", path.string(), error.message()));
  const std::filesystem::path lock_path = path / ".lock";
  const int lock = ::open(lock_path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock < 0) return FileError(fmt::format("{}: cannot be written: {}", path.string(), std::strerror(errno)));
  std::unique_ptr<BatchFolder> folder(new BatchFolder(path, lock));
  if (::flock(lock, LOCK_EX | LOCK_NB) != 0) {
    return FileError(
        fmt::format("{}: another flair batch is collecting into it; let it end, or stop it first", path.string()));
  }
  ASSIGN_OR_RETURN(folder->results_, ResultsFile::Open(ResultsPath(path)));
  return folder;
}

BatchFolder::~BatchFolder() { ::close(lock_); }

absl::StatusOr<BatchPlace> BatchFolder::Place() { return Read(*results_); }

absl::Status BatchFolder::SetPlace(const BatchPlace& place) {
  return results_->Change([&]() -> absl::Status {
    for (const TextState& state : kTextStates) {
      RETURN_IF_ERROR(results_->SetState(state.name, place.*state.field));
    }
    return results_->SetState(kShardSize, int64_t{place.shard_size});
  });
}

}  // namespace flair::cli
