// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/line_reader.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "cli/exit_code.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

constexpr size_t kReadAtOnce = 1u << 20;
constexpr size_t kShownOfTooLong = 1000;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

absl::Status CannotRead(const std::filesystem::path& path) {
  return FileError(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)));
}

}  // namespace

absl::StatusOr<std::unique_ptr<LineReader>> LineReader::Open(const std::filesystem::path& path, int64_t offset,
                                                             int64_t number) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0 && errno == ENOENT) return absl::NotFoundError(fmt::format("{}: no such file", path.string()));
  if (file < 0) return CannotRead(path);
  std::unique_ptr<LineReader> reader(new LineReader(path, file, offset, number));
  if (offset > 0 && ::lseek(file, offset, SEEK_SET) < 0) return CannotRead(path);
  return reader;
}

LineReader::~LineReader() { ::close(file_); }

absl::StatusOr<bool> LineReader::Fill() {
  buffer_.erase(0, used_);
  used_ = 0;
  const size_t before = buffer_.size();
  buffer_.resize(before + kReadAtOnce);
  ssize_t count = 0;
  do {
    count = ::read(file_, buffer_.data() + before, kReadAtOnce);
  } while (count < 0 && errno == EINTR);
  buffer_.resize(before + static_cast<size_t>(count < 0 ? 0 : count));
  if (count < 0) return CannotRead(path_);
  return count > 0;
}

void LineReader::Trim(Line& line) const {
  if (line.text.ends_with('\r')) line.text.remove_suffix(1);
  if (line.number == 1 && line.text.starts_with(kByteOrderMark)) line.text.remove_prefix(kByteOrderMark.size());
}

absl::StatusOr<bool> LineReader::SkipRest(Line& line) {
  beginning_ = buffer_.substr(used_, kShownOfTooLong);
  line.too_long = true;
  while (true) {
    const size_t end = buffer_.find('\n', used_);
    const size_t taken = end == std::string::npos ? buffer_.size() - used_ : end + 1 - used_;
    offset_ += static_cast<int64_t>(taken);
    used_ += taken;
    if (end != std::string::npos) break;
    const absl::StatusOr<bool> more = Fill();
    if (!more.ok()) return more;
    if (!*more) break;
  }
  line.text = beginning_;
  line.end_offset = offset_;
  return true;
}

absl::StatusOr<bool> LineReader::Next(Line& line) {
  size_t searched = used_;
  size_t end = 0;
  while ((end = buffer_.find('\n', searched)) == std::string::npos) {
    const size_t left = buffer_.size() - used_;
    if (left > kLongestLine) break;
    const absl::StatusOr<bool> more = Fill();
    if (!more.ok()) return more;
    if (!*more) {
      if (buffer_.empty()) return false;
      end = buffer_.size();
      break;
    }
    searched = left;
  }
  line = Line();
  line.number = number_++;
  if (end == std::string::npos || end - used_ > kLongestLine) return SkipRest(line);
  line.text = std::string_view(buffer_).substr(used_, end - used_);
  const size_t next = std::min(end + 1, buffer_.size());
  offset_ += static_cast<int64_t>(next - used_);
  used_ = next;
  line.end_offset = offset_;
  Trim(line);
  return true;
}

}  // namespace flair::cli
