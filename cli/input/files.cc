// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/files.h"

#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/text_format.h>
#include <google/protobuf/util/json_util.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "cli/exit_code.h"
#include "fmt/format.h"
#include "orchestrator/store/artifact_id.h"

namespace flair::cli {
namespace {

constexpr uintmax_t kLargestFile = 256u << 20;

bool LooksLikeJson(const std::string& bytes) {
  const size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string::npos && bytes[first] == '{';
}

// Bytes cannot tell text format from binary for sure; the name does.
bool IsNamedText(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".textproto" || extension == ".txtpb" || extension == ".pbtxt";
}

// Keeps the first complaint, with its place.
class FirstError : public google::protobuf::io::ErrorCollector {
 public:
  void AddError(int line, int column, const std::string& message) override {
    if (first_.empty()) first_ = fmt::format("line {}, column {}: {}", line + 1, column + 1, message);
  }
  const std::string& first() const { return first_; }

 private:
  std::string first_;
};

absl::Status FromText(const std::string& text, google::protobuf::Message& message) {
  FirstError error;
  google::protobuf::TextFormat::Parser parser;
  parser.RecordErrorsTo(&error);
  parser.SetRecursionLimit(100);
  return parser.ParseFromString(text, &message) ? absl::OkStatus() : absl::InvalidArgumentError(error.first());
}

// As the problems that `flair import flairgpt` reads.
bool LooksRecorded(const std::string& json) {
  return json.find("\"fixed_objects\"") != std::string::npos && json.find("\"calls\"") != std::string::npos;
}

absl::Status FromJson(const std::string& bytes, google::protobuf::Message& message) {
  const auto status = google::protobuf::util::JsonStringToMessage(bytes, &message);
  return status.ok() ? absl::OkStatus() : absl::InvalidArgumentError(status.ToString());
}

absl::Status NoArtifact(const std::filesystem::path& path, const std::string& why) {
  return absl::DataLossError(fmt::format(
      "{}: not a Flair artifact ({}); expected a .pb, .json or .textproto file that Flair wrote", path.string(), why));
}

}  // namespace

absl::StatusOr<std::string> ReadFile(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return absl::NotFoundError(fmt::format("{}: no such file", path.string()));
  if (std::filesystem::is_directory(path, error)) return FileError(fmt::format("{}: is a folder", path.string()));
  if (std::filesystem::file_size(path, error) > kLargestFile && !error) {
    return absl::InvalidArgumentError(fmt::format("{}: larger than {} MiB", path.string(), kLargestFile >> 20));
  }
  std::ifstream file(path, std::ios::binary);
  std::string content((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (!file || file.bad()) return FileError(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)));
  return content;
}

absl::StatusOr<v1::Artifact> ReadArtifact(const std::filesystem::path& path) {
  const absl::StatusOr<std::string> bytes = ReadFile(path);
  if (!bytes.ok()) return bytes.status();
  if (bytes->empty()) return NoArtifact(path, "the file is empty");
  v1::Artifact artifact;
  if (IsNamedText(path)) {
    if (const absl::Status status = FromText(*bytes, artifact); !status.ok()) {
      return NoArtifact(path, std::string(status.message()));
    }
  } else if (LooksLikeJson(*bytes)) {
    if (const absl::Status status = FromJson(*bytes, artifact); !status.ok()) {
      if (LooksRecorded(*bytes)) {
        return absl::InvalidArgumentError(fmt::format(
            "{0}: a recorded FlairGPT problem, no artifact; first: flair import flairgpt {0} --out graph.pb",
            path.string()));
      }
      return NoArtifact(path, std::string(status.message()));
    }
  } else if (!artifact.ParseFromString(*bytes)) {
    return NoArtifact(path, fmt::format("its {} bytes cannot be parsed", bytes->size()));
  }
  if (artifact.content_case() == v1::Artifact::CONTENT_NOT_SET) return NoArtifact(path, "it has no content");
  return artifact;
}

absl::StatusOr<v1::Room> ReadRoom(const std::filesystem::path& path) {
  const absl::StatusOr<std::string> bytes = ReadFile(path);
  if (!bytes.ok()) return bytes.status();
  if (const absl::StatusOr<v1::Artifact> artifact = ReadArtifact(path); artifact.ok()) {
    if (const absl::Status status = CheckArtifactId(*artifact, path); !status.ok()) return status;
    switch (artifact->content_case()) {
      case v1::Artifact::kRoom:
        return artifact->room();
      case v1::Artifact::kLayoutGraph:
        return artifact->layout_graph().room();
      case v1::Artifact::kSolvedLayout:
        return artifact->solved_layout().graph().room();
      default:
        return absl::InvalidArgumentError(fmt::format("{}: an artifact without a room", path.string()));
    }
  }
  v1::Room room;
  const absl::Status status = LooksLikeJson(*bytes)          ? FromJson(*bytes, room)
                              : room.ParseFromString(*bytes) ? absl::OkStatus()
                                                             : absl::InvalidArgumentError("its bytes cannot be parsed");
  if (status.ok()) return room;
  return absl::InvalidArgumentError(fmt::format("{}: holds no room: {}", path.string(), std::string(status.message())));
}

absl::Status CheckArtifactId(const v1::Artifact& artifact, const std::filesystem::path& path) {
  const std::string right = orchestrator::ComputeArtifactId(artifact);
  if (right == artifact.id()) return absl::OkStatus();
  return absl::DataLossError(fmt::format("{}: corrupt: its bytes have the id {}, but it says {}", path.string(), right,
                                         artifact.id().empty() ? "none" : artifact.id()));
}

}  // namespace flair::cli
