// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/wrappers/answer_folder.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "fmt/format.h"
#include "llm/wrappers/answer_json.h"
#include "worker_runtime/files/files.h"

namespace flair::llm {
namespace {

constexpr char kIdentityFile[] = "identity";

std::optional<std::string> ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

absl::Status MakeFolder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (!error) return absl::OkStatus();
  return absl::FailedPreconditionError(
      fmt::format("{}: the folder for answers cannot be made: {}", path, error.message()));
}

// Steps are words, dots and slashes; whatever else is in one does not get into a file's name.
std::string FileStem(const std::string& step) {
  std::string stem;
  for (const char c : step.substr(0, 60)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    stem.push_back(plain ? c : '.');
  }
  return stem.empty() || stem.front() == '.' ? "call" + stem : stem;
}

}  // namespace

std::string AnswerFolder::FileName(const ChatRequest& request) {
  return fmt::format("{}-{}.json", FileStem(request.step), runtime::Sha256Hex(RequestJson(request)).substr(0, 16));
}

absl::Status AnswerFolder::ClaimFor(const std::string& identity) const {
  if (absl::Status status = MakeFolder(path_); !status.ok()) return status;
  const absl::StatusOr<std::string> found = Identity();
  if (found.ok() && *found == identity) return absl::OkStatus();
  if (found.ok()) {
    return absl::FailedPreconditionError(
        fmt::format("{}: holds answers of \"{}\", not of \"{}\"; choose another folder", path_, *found, identity));
  }
  return runtime::WriteFileAtomically(path_ + "/" + kIdentityFile, identity + "\n");
}

absl::StatusOr<std::string> AnswerFolder::Identity() const {
  std::optional<std::string> text = ReadFile(path_ + "/" + kIdentityFile);
  if (!text.has_value()) {
    return absl::NotFoundError(
        fmt::format("{}: no recorded answers: its file \"{}\" is missing", path_, kIdentityFile));
  }
  while (!text->empty() && text->back() == '\n') text->pop_back();
  return *text;
}

absl::StatusOr<std::optional<ChatAnswer>> AnswerFolder::Find(const ChatRequest& request) const {
  const std::string path = path_ + "/" + FileName(request);
  const std::optional<std::string> text = ReadFile(path);
  if (!text.has_value()) return std::optional<ChatAnswer>();
  absl::StatusOr<ChatAnswer> answer = ReadRecordJson(*text);
  if (answer.ok()) return std::optional<ChatAnswer>(*std::move(answer));
  return absl::DataLossError(
      fmt::format("{}: not a recorded answer: {}", path, std::string(answer.status().message())));
}

absl::StatusOr<ChatAnswer> AnswerFolder::Put(const ChatRequest& request, const ChatAnswer& answer) const {
  if (absl::Status status = MakeFolder(path_); !status.ok()) return status;
  const absl::StatusOr<std::optional<ChatAnswer>> before = Find(request);
  if (before.ok() && before->has_value()) return **before;
  const absl::Status written =
      runtime::WriteFileAtomically(path_ + "/" + FileName(request), RecordJson(request, answer));
  if (!written.ok()) return written;
  return answer;
}

}  // namespace flair::llm
