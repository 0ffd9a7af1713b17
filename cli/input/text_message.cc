// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/text_message.h"

#include "cli/input/files.h"
#include "cli/input/message_text.h"
#include "fmt/format.h"

namespace flair::cli {

absl::Status ReadTextMessage(const std::string& flag, const std::string& path, const std::string& example,
                             google::protobuf::Message& message) {
  const absl::StatusOr<std::string> text = ReadFile(path);
  if (!text.ok()) {
    return absl::Status(text.status().code(), fmt::format("{}: {}", flag, std::string(text.status().message())));
  }
  const absl::Status read = ParseMessageText(TextForm::kProtobufText, path, *text, message);
  if (read.ok()) return read;
  return absl::InvalidArgumentError(fmt::format("{}: {}; should hold {}", flag, std::string(read.message()), example));
}

}  // namespace flair::cli
