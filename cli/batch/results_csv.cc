// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdio.h>

#include <cerrno>
#include <fstream>

#include "cli/batch/batch_report.h"
#include "cli/output/output_folder.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

std::string Quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

std::string Cell(const ResultValue& value) {
  if (const auto* number = std::get_if<int64_t>(&value)) return fmt::format("{}", *number);
  if (const auto* real = std::get_if<double>(&value)) return fmt::format("{}", *real);
  if (const auto* text = std::get_if<std::string>(&value)) return Quoted(*text);
  return "";
}

absl::Status WriteRows(ResultsFile& results, std::ofstream& file) {
  std::string line;
  for (const ResultColumn& column : ResultColumns()) line += (line.empty() ? "" : ",") + column.name;
  file << line << "\r\n";
  return results.ForEach("", [&](const ResultRow& row) {
    line.clear();
    for (size_t i = 0; i < row.values().size(); ++i) line += (i == 0 ? "" : ",") + Cell(row.values()[i]);
    file << line << "\r\n";
    return file.fail() ? absl::UnavailableError("") : absl::OkStatus();
  });
}

}  // namespace

absl::Status WriteResultsCsv(ResultsFile& results, const std::string& path) {
  RETURN_IF_ERROR(CheckOutputFile(path));
  std::error_code error;
  // A device or pipe is written to as it is.
  const bool in_place = std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error);
  const std::string made = in_place ? path : path + ".partial";
  std::ofstream file(made, std::ios::binary | std::ios::trunc);
  const absl::Status status = WriteRows(results, file);
  file.close();
  if (file.fail() || (status.ok() && !in_place && ::rename(made.c_str(), path.c_str()) != 0)) {
    const int reason = errno;
    if (!in_place) std::filesystem::remove(made, error);
    return CannotWrite(path, reason);
  }
  return status;
}

}  // namespace flair::cli
