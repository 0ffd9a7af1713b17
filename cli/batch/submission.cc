// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/batch_run.h"

#include <system_error>

#include "absl/strings/ascii.h"
#include "cli/exit_code.h"
#include "cli/output/artifact_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

constexpr int kPageJobs = 500;
constexpr size_t kPageBytes = 512 << 10;
constexpr int64_t kSeedLimit = int64_t{1} << 53;

// Names of what is remembered, see ResultsFile::State.
constexpr char kOffset[] = "submit_offset";
constexpr char kLine[] = "submit_line";
constexpr char kSubmitted[] = "submitted_count";
constexpr char kRejected[] = "rejected_count";
constexpr char kRejectedBytes[] = "rejected_bytes";

// A line that was wrong is mostly short; one that has no end must not fill the disk.
constexpr size_t kLongestText = 64 << 10;

}  // namespace

std::string Submission::RequestId(const BatchInput& input, const Options& options, const std::string& label) {
  const std::string options_digest = runtime::Sha256Hex(runtime::CanonicalBytes(options.defaults));
  const std::string all =
      fmt::format("flair batch 1\n{}\n{}\n{}\n{}\n", input.sha256, options_digest, options.seed_count, label);
  return "batch-" + runtime::Sha256Hex(all);
}

absl::Status Submission::Restore(const v1::Batch& batch) {
  known_count_ = batch.job_count();
  const struct {
    const char* name;
    int64_t value;
  } states[] = {{kOffset, 0}, {kLine, 1}, {kSubmitted, 0}, {kRejected, 0}, {kRejectedBytes, 0}};
  int64_t values[std::size(states)];
  for (size_t i = 0; i < std::size(states); ++i) {
    ASSIGN_OR_RETURN(const int64_t value, results_.IntState(states[i].name));
    values[i] = std::max(value, states[i].value);
  }
  next_offset_ = values[0];
  next_line_ = values[1];
  submitted_count_ = values[2];
  rejected_count_ = values[3];
  page_.set_batch_id(batch.id());
  page_.set_first_index(submitted_count_);
  return rejected_.Open(values[4]);
}

void Submission::Take(const Line& line) {
  next_offset_ = line.end_offset;
  next_line_ = line.number + 1;
  if (absl::StripAsciiWhitespace(absl::string_view(line.text.data(), line.text.size())).empty()) return;
  absl::StatusOr<BriefLine> read = line.too_long
                                       ? InvalidArgument("is longer than {} MiB", LineReader::kLongestLine >> 20)
                                       : ReadBriefLine(line.text, options_.defaults);
  const int64_t first_seed = read.ok() ? read->spec.brief().seed() : 0;
  if (read.ok() && first_seed + options_.seed_count > kSeedLimit) {
    read = InvalidArgument("seed: is {}; with {} seeds expected at most 2^53 - {}", first_seed, options_.seed_count,
                           options_.seed_count);
  }
  if (!read.ok()) {
    rejected_.Add(line.number, std::string(read.status().message()), line.text);
    ++rejected_count_;
    return;
  }
  for (int i = 0; i < options_.seed_count; ++i) {
    v1::JobSpec& spec = *page_.add_specs();
    spec = read->spec;
    spec.mutable_brief()->set_seed(first_seed + i);
    page_bytes_ += spec.ByteSizeLong();
    ResultRow row;
    row.Set("batch_index", page_.first_index() + page_.specs_size() - 1);
    row.Set("line", line.number);
    if (!read->key.empty()) row.Set("key", read->key);
    row.Set("state", "waiting");
    row.Set("seed", spec.brief().seed());
    row.Set("text", spec.brief().text());
    rows_.push_back(std::move(row));
  }
}

absl::Status Submission::Remember() {
  RETURN_IF_ERROR(rejected_.Flush());
  return results_.Change([this]() -> absl::Status {
    for (const ResultRow& row : rows_) {
      // The job may have ended already: its row then only lacks what this one knows.
      ASSIGN_OR_RETURN(const std::optional<ResultRow> known, results_.Find(row.Int("batch_index")));
      ResultRow put = row;
      if (known.has_value()) put.Set("state", known->Get("state"));
      RETURN_IF_ERROR(results_.Put(put));
    }
    const std::pair<const char*, int64_t> states[] = {{kOffset, next_offset_},
                                                      {kLine, next_line_},
                                                      {kSubmitted, page_.first_index() + page_.specs_size()},
                                                      {kRejected, rejected_count_},
                                                      {kRejectedBytes, rejected_.size_bytes()}};
    for (const auto& [name, value] : states) RETURN_IF_ERROR(results_.SetState(name, value));
    return absl::OkStatus();
  });
}

absl::Status Submission::Send(const v1::AddToBatchRequest& request) {
  return session_.AddToBatch(request, options_.waits).status();
}

absl::Status Submission::SendOneByOne() {
  const v1::AddToBatchRequest refused = page_;
  const std::vector<ResultRow> rows = std::move(rows_);
  rows_.clear();
  page_.clear_specs();
  for (int i = 0; i < refused.specs_size(); ++i) {
    const int64_t index = page_.first_index() + page_.specs_size();
    v1::AddToBatchRequest one;
    one.set_batch_id(refused.batch_id());
    one.set_first_index(index);
    *one.add_specs() = refused.specs(i);
    const absl::Status status = Send(one);
    if (absl::IsInvalidArgument(status)) {
      rejected_.Add(rows[i].Int("line"), std::string(status.message()), ToJsonLine(refused.specs(i)));
      ++rejected_count_;
      continue;
    }
    if (!status.ok()) return status;
    *page_.add_specs() = refused.specs(i);
    rows_.push_back(rows[i]);
    rows_.back().Set("batch_index", index);
  }
  return absl::OkStatus();
}

absl::Status Submission::SendPage(bool last) {
  page_.set_last(last);
  if (last || page_.first_index() + page_.specs_size() > known_count_) {
    absl::Status status = Send(page_);
    if (absl::IsInvalidArgument(status) && page_.specs_size() > 0) {
      status = SendOneByOne();
      if (status.ok() && last) {
        v1::AddToBatchRequest end;
        end.set_batch_id(page_.batch_id());
        end.set_first_index(page_.first_index() + page_.specs_size());
        end.set_last(true);
        status = Send(end);
      }
    }
    if (!status.ok()) return status;
  }
  RETURN_IF_ERROR(Remember());
  submitted_count_ = page_.first_index() + page_.specs_size();
  page_.set_first_index(submitted_count_);
  page_.clear_specs();
  page_bytes_ = 0;
  rows_.clear();
  return absl::OkStatus();
}

absl::Status Submission::Run(const v1::Batch& batch) {
  RETURN_IF_ERROR(Restore(batch));
  ASSIGN_OR_RETURN(const std::unique_ptr<LineReader> reader, LineReader::Open(input_.path, next_offset_, next_line_));
  Line line;
  while (true) {
    ASSIGN_OR_RETURN(const bool more, reader->Next(line));
    if (!more) break;
    Take(line);
    if (session_.stopped()) return absl::CancelledError("interrupted");
    if (page_.specs_size() < kPageJobs && page_bytes_ < kPageBytes) continue;
    RETURN_IF_ERROR(SendPage(false));
  }
  if (next_offset_ != input_.size_bytes) {
    return InvalidArgument(
        "{}: changed while it was being read: {} bytes, now {}; try again with a file that does not change",
        input_.path.string(), input_.size_bytes, next_offset_);
  }
  return SendPage(true);
}

absl::Status RejectedLines::Open(int64_t size_bytes) {
  std::error_code error;
  size_bytes_ = size_bytes;
  if (std::filesystem::exists(path_, error)) {
    if (size_bytes == 0) {
      std::filesystem::remove(path_, error);
    } else {
      std::filesystem::resize_file(path_, static_cast<uintmax_t>(size_bytes), error);
    }
  }
  if (!error) return absl::OkStatus();
  return FileError("{}: cannot be written: {}", path_.string(), error.message());
}

void RejectedLines::Add(int64_t line, const std::string& reason, std::string_view text) {
  // The file is made for the first of them.
  if (!file_.is_open()) file_.open(path_, std::ios::app | std::ios::binary);
  const nlohmann::ordered_json object = {
      {"line", line}, {"reason", reason}, {"text", std::string(text.substr(0, kLongestText))}};
  const std::string written = JsonText(object) + "\n";
  file_ << written;
  size_bytes_ += static_cast<int64_t>(written.size());
}

absl::Status RejectedLines::Flush() {
  if (!file_.is_open() && size_bytes_ == 0) return absl::OkStatus();
  if (file_.is_open()) file_.flush();
  if (!file_.fail()) return absl::OkStatus();
  return FileError("{}: cannot be written; is the disk full?", path_.string());
}

}  // namespace flair::cli
