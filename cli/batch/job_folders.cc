// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <stdio.h>

#include <atomic>
#include <cerrno>

#include "cli/batch/result_writer.h"
#include "cli/batch/write_file.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

namespace fs = std::filesystem;

constexpr int64_t kJobsInAFolder = 1000;

class JobFolders final : public ResultWriter {
 public:
  explicit JobFolders(fs::path folder) : folder_(std::move(folder)) {}

  absl::StatusOr<Place> Write(int64_t batch_index, const std::vector<OutputFile>& files) override {
    const std::string path = fmt::format("jobs/{:03}/{}", batch_index / kJobsInAFolder, IndexName(batch_index));
    const fs::path final_folder = folder_ / path;
    const fs::path made = final_folder.parent_path() / fmt::format(".{}.partial", IndexName(batch_index));
    std::error_code error;
    fs::remove_all(made, error);  // of a process that was killed
    fs::create_directories(made, error);
    if (error) return CannotWrite(made, error.value());
    for (const OutputFile& file : files) {
      if (absl::Status status = WriteFile(made / file.name, file.content); !status.ok()) return status;
    }
    if (absl::Status status = PutInPlace(made, final_folder); !status.ok()) return status;
    return Place{.path = path, .ticket = ++last_ticket_};
  }

  absl::Status Settle(bool) override {
    const int64_t written = last_ticket_;
    if (written == settled_) return absl::OkStatus();
    if (absl::Status status = FlushFileSystem(folder_); !status.ok()) return status;
    settled_ = written;
    return absl::OkStatus();
  }

  bool IsSettled(int64_t ticket) override { return ticket <= settled_; }

 private:
  static absl::Status PutInPlace(const fs::path& made, const fs::path& final_folder) {
    if (::rename(made.c_str(), final_folder.c_str()) == 0) return absl::OkStatus();
    if (errno != ENOTEMPTY && errno != EEXIST) return CannotWrite(final_folder, errno);
    // The job ran again: the two change places, then the old one goes.
    if (::renameat2(AT_FDCWD, made.c_str(), AT_FDCWD, final_folder.c_str(), RENAME_EXCHANGE) != 0) {
      return CannotWrite(final_folder, errno);
    }
    std::error_code ignored;
    fs::remove_all(made, ignored);
    return absl::OkStatus();
  }

  const fs::path folder_;
  std::atomic<int64_t> last_ticket_ = 0;
  std::atomic<int64_t> settled_ = 0;
};

}  // namespace

std::string IndexName(int64_t batch_index) { return fmt::format("{:06}", batch_index); }

std::unique_ptr<ResultWriter> MakeJobFolders(const fs::path& folder) { return std::make_unique<JobFolders>(folder); }

}  // namespace flair::cli
