// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace google::protobuf {
class Descriptor;
class Message;
}  // namespace google::protobuf

namespace flair::runtime {

// Collects what is wrong with a config file, each with its place. Given to the checks of a program's own fields.
class ConfigChecker {
 public:
  virtual ~ConfigChecker() = default;

  // Remembers that the field at `path` (such as "runtime.queue_limit" or "tokens[2].name") is bad; `problem` says the
  // value and what would be right.
  virtual void Report(std::string_view path, std::string_view problem) = 0;

  // Reports unless low <= value <= high.
  void Range(std::string_view path, double value, double low, double high);
};

// Reads a text proto into `config` and checks it: the fields of RuntimeConfig in a field named `runtime`, then `check`.
// INVALID_ARGUMENT lists every bad field, one per line, as "FILE:LINE: PATH: what is wrong"; NOT_FOUND when there is no
// such file. Line numbers start at 1.
absl::Status ReadConfigFile(const std::string& path, google::protobuf::Message& config,
                            const std::function<void(ConfigChecker&)>& check);

// As ReadConfigFile, from a string; `name` stands for the file in messages.
absl::Status ReadConfigText(const std::string& name, const std::string& text, google::protobuf::Message& config,
                            const std::function<void(ConfigChecker&)>& check);

// One line per field of the config and of the messages inside it, for --help.
std::string DescribeConfig(const google::protobuf::Descriptor& descriptor);

}  // namespace flair::runtime
