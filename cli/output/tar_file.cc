// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/tar_file.h"

#include <archive.h>
#include <archive_entry.h>

#include <cstdint>
#include <utility>

#include "cli/exit_code.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {

TarFile::TarFile(std::filesystem::path path, bool zip) : path_(std::move(path)), archive_(archive_write_new()) {
  zip ? archive_write_set_format_zip(archive_) : archive_write_set_format_pax_restricted(archive_);
}

TarFile::~TarFile() { archive_write_free(archive_); }

absl::StatusOr<std::unique_ptr<TarFile>> TarFile::Make(const std::filesystem::path& path) {
  std::unique_ptr<TarFile> file(new TarFile(path));
  std::error_code error;
  std::filesystem::remove(path, error);  // what is there may be a link to another file
  if (archive_write_open_filename(file->archive_, path.c_str()) != ARCHIVE_OK) return file->Error();
  return file;
}

absl::Status TarFile::Add(const std::string& name, const std::string& content) {
  const std::unique_ptr<archive_entry, decltype(&archive_entry_free)> entry(archive_entry_new(), archive_entry_free);
  archive_entry_set_pathname(entry.get(), name.c_str());
  archive_entry_set_size(entry.get(), static_cast<int64_t>(content.size()));
  archive_entry_set_filetype(entry.get(), AE_IFREG);
  archive_entry_set_perm(entry.get(), 0644);
  archive_entry_set_mtime(entry.get(), 0, 0);
  if (archive_write_header(archive_, entry.get()) != ARCHIVE_OK) return Error();
  if (archive_write_data(archive_, content.data(), content.size()) != static_cast<la_ssize_t>(content.size())) {
    return Error();
  }
  return absl::OkStatus();
}

absl::Status TarFile::Close() { return archive_write_close(archive_) == ARCHIVE_OK ? absl::OkStatus() : Error(); }

absl::Status TarFile::Error() const {
  const char* why = archive_error_string(archive_);
  return FileError("{}: cannot be written: {}", path_.string(), why == nullptr ? "no reason given" : why);
}

absl::StatusOr<std::string> ArchiveOf(std::span<const OutputFile> files, bool zip) {
  TarFile file("archive", zip);
  const auto append = [](archive*, void* bytes, const void* part, size_t size) -> la_ssize_t {
    static_cast<std::string*>(bytes)->append(static_cast<const char*>(part), size);
    return static_cast<la_ssize_t>(size);
  };
  std::string bytes;
  if (archive_write_open(file.archive_, &bytes, nullptr, append, nullptr) != ARCHIVE_OK) return file.Error();
  for (const OutputFile& one : files) RETURN_IF_ERROR(file.Add(one.name, one.content));
  RETURN_IF_ERROR(file.Close());
  return bytes;
}

}  // namespace flair::cli
