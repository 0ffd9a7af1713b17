// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/brief_file.h"

#include <google/protobuf/util/json_util.h>

#include "cli/input/files.h"
#include "cli/input/text_message.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

constexpr char kExample[] = "a Brief, such as: text: \"A bedroom.\" object_list { objects { id: \"bed\" ... } }";

}  // namespace

absl::StatusOr<v1::Brief> ReadBrief(const std::string& flag, const std::string& path) {
  const absl::StatusOr<std::string> bytes = ReadFile(path);
  if (!bytes.ok()) {
    return absl::Status(bytes.status().code(), fmt::format("{}: {}", flag, std::string(bytes.status().message())));
  }
  if (const absl::StatusOr<v1::Artifact> artifact = ReadArtifact(path); artifact.ok()) {
    if (absl::Status status = CheckArtifactId(*artifact, path); !status.ok()) return status;
    if (artifact->has_brief()) return artifact->brief();
    return absl::InvalidArgumentError(fmt::format("{}: {}: an artifact without a brief; should be {}", flag, path,
                                                  "brief.pb or brief.json of a design, or a Brief"));
  }
  v1::Brief brief;
  const size_t first = bytes->find_first_not_of(" \t\r\n");
  if (first != std::string::npos && (*bytes)[first] == '{') {
    const auto status = google::protobuf::util::JsonStringToMessage(*bytes, &brief);
    if (status.ok()) return brief;
    return absl::InvalidArgumentError(
        fmt::format("{}: {}: {}; should hold {}", flag, path, std::string(status.message()), kExample));
  }
  if (absl::Status status = ReadTextMessage(flag, path, kExample, brief); !status.ok()) return status;
  return brief;
}

}  // namespace flair::cli
