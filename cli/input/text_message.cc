// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/text_message.h"

#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/text_format.h>

#include "cli/input/files.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

// Keeps the first error.
class FirstError final : public google::protobuf::io::ErrorCollector {
 public:
  void AddError(int line, google::protobuf::io::ColumnNumber column, const std::string& message) override {
    if (text.empty()) text = fmt::format("line {}, column {}: {}", line + 1, column + 1, message);
  }
  std::string text;
};

}  // namespace

absl::Status ReadTextMessage(const std::string& flag, const std::string& path, const std::string& example,
                             google::protobuf::Message& message) {
  const absl::StatusOr<std::string> text = ReadFile(path);
  if (!text.ok()) {
    return absl::Status(text.status().code(), fmt::format("{}: {}", flag, std::string(text.status().message())));
  }
  FirstError error;
  google::protobuf::TextFormat::Parser parser;
  parser.RecordErrorsTo(&error);
  if (parser.ParseFromString(*text, &message)) return absl::OkStatus();
  return absl::InvalidArgumentError(fmt::format("{}: {}: {}; should hold {}", flag, path, error.text, example));
}

}  // namespace flair::cli
