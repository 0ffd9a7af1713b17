// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/config/config_reader.h"

#include <fmt/format.h>
#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/text_format.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

#include "flair/config/v1/runtime_config.pb.h"
#include "worker_runtime/security/security.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::runtime {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::TextFormat;

struct Problem {
  int line;
  std::string text;
};

class ErrorCollector final : public google::protobuf::io::ErrorCollector {
 public:
  explicit ErrorCollector(std::vector<Problem>& problems) : problems_(problems) {}
  void AddError(int line, int column, const std::string& message) override { problems_.push_back({line, message}); }
  // Unknown fields arrive as warnings, so that the rest of the file is read as well.
  void AddWarning(int line, int column, const std::string& message) override { AddError(line, column, message); }

 private:
  std::vector<Problem>& problems_;
};

// Finds the line of a field by its path.
class LocatedChecker final : public ConfigChecker {
 public:
  LocatedChecker(const google::protobuf::Descriptor& descriptor, TextFormat::ParseInfoTree& tree,
                 std::vector<Problem>& problems)
      : descriptor_(descriptor), tree_(tree), problems_(problems) {}

  void Report(std::string_view path, std::string_view problem) override {
    problems_.push_back({LineOf(path), fmt::format("{}: {}", path, problem)});
  }

 private:
  // "tokens[2]" is "tokens" and 2.
  static std::pair<std::string, int> NameAndIndex(std::string_view part) {
    const size_t bracket = part.find('[');
    if (bracket == std::string_view::npos) return {std::string(part), 0};
    return {std::string(part.substr(0, bracket)), std::atoi(std::string(part.substr(bracket + 1)).c_str())};
  }

  int LineOf(std::string_view path) const {
    const google::protobuf::Descriptor* message = &descriptor_;
    TextFormat::ParseInfoTree* tree = &tree_;
    int line = -1;
    while (message != nullptr && tree != nullptr && !path.empty()) {
      const size_t dot = path.find('.');
      const auto [name, index] = NameAndIndex(path.substr(0, dot));
      const FieldDescriptor* field = message->FindFieldByName(name);
      path = dot == std::string_view::npos ? "" : path.substr(dot + 1);
      if (field == nullptr) break;
      const int found = tree->GetLocation(field, field->is_repeated() ? index : -1).line;
      if (found >= 0) line = found;
      if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) break;
      message = field->message_type();
      tree = tree->GetTreeForNested(field, field->is_repeated() ? index : -1);
    }
    return line;
  }

  const google::protobuf::Descriptor& descriptor_;
  TextFormat::ParseInfoTree& tree_;
  std::vector<Problem>& problems_;
};

void CheckRuntime(const config::v1::RuntimeConfig& runtime, ConfigChecker& checker) {
  if (runtime.worker_thread_count() != 0) {
    checker.Range("runtime.worker_thread_count", runtime.worker_thread_count(), 1, 1024);
  }
  if (runtime.queue_limit() != 0) checker.Range("runtime.queue_limit", runtime.queue_limit(), 1, 100000);
  if (runtime.has_drain_seconds()) checker.Range("runtime.drain_seconds", runtime.drain_seconds(), 0, 600);
  if (runtime.max_message_mib() != 0) checker.Range("runtime.max_message_mib", runtime.max_message_mib(), 1, 256);
  const std::string& level = runtime.log_level();
  if (!level.empty() && level != "debug" && level != "info" && level != "warning" && level != "error") {
    checker.Report("runtime.log_level",
                   fmt::format("\"{}\" is not a level; expected debug, info, warning or error", level));
  }
  const std::string& format = runtime.log_format();
  if (!format.empty() && format != "text" && format != "json") {
    checker.Report("runtime.log_format", fmt::format("\"{}\" is not a format; expected text or json", format));
  }
  if (!runtime.metrics_address().empty()) {
    const absl::Status status = CheckMetricsAddress(runtime.metrics_address());
    if (!status.ok()) checker.Report("runtime.metrics_address", std::string(status.message()));
  }
}

void CheckTls(const config::v1::TlsConfig& tls, ConfigChecker& checker) {
  const std::string missing = "missing; expected a PEM file";
  if (tls.certificate_path().empty()) checker.Report("runtime.tls.certificate_path", missing);
  if (tls.key_path().empty()) checker.Report("runtime.tls.key_path", missing);
  if (tls.require_client_certificate() && tls.authority_path().empty()) {
    checker.Report("runtime.tls.authority_path", missing + " with the authorities of the callers' certificates");
  }
  if (!tls.client_names().empty() && !tls.require_client_certificate()) {
    checker.Report("runtime.tls.client_names", "names nobody has to show; set require_client_certificate");
  }
}

// Whether the program asks its callers for tokens, if it can: its config has a tokens_path then.
std::optional<bool> AsksForTokens(const google::protobuf::Message& config) {
  const FieldDescriptor* field = config.GetDescriptor()->FindFieldByName("tokens_path");
  if (field == nullptr || field->cpp_type() != FieldDescriptor::CPPTYPE_STRING) return std::nullopt;
  return !config.GetReflection()->GetString(config, field).empty();
}

void CheckExposure(const config::v1::RuntimeConfig& runtime, std::optional<bool> asks_for_tokens,
                   ConfigChecker& checker) {
  const std::string fault = ExposureFault(runtime, asks_for_tokens);
  if (!fault.empty()) checker.Report("runtime.listen_address", fault);
  const std::string metrics_fault = MetricsExposureFault(runtime);
  if (!metrics_fault.empty()) checker.Report("runtime.metrics_address", metrics_fault);
}

const config::v1::RuntimeConfig* FindRuntime(const google::protobuf::Message& config) {
  const FieldDescriptor* field = config.GetDescriptor()->FindFieldByName("runtime");
  if (field == nullptr) return nullptr;
  return dynamic_cast<const config::v1::RuntimeConfig*>(&config.GetReflection()->GetMessage(config, field));
}

absl::Status ToStatus(const std::string& name, std::vector<Problem> problems) {
  if (problems.empty()) return absl::OkStatus();
  std::ranges::stable_sort(problems, [](const Problem& a, const Problem& b) { return a.line < b.line; });
  std::string text;
  for (const Problem& problem : problems) {
    const std::string place = problem.line < 0 ? name : fmt::format("{}:{}", name, problem.line + 1);
    text += fmt::format("{}{}: {}", text.empty() ? "" : "\n", place, problem.text);
  }
  return absl::InvalidArgumentError(text);
}

void DescribeFields(const google::protobuf::Descriptor& descriptor, const std::string& prefix, std::string& out) {
  for (int i = 0; i < descriptor.field_count(); ++i) {
    const FieldDescriptor& field = *descriptor.field(i);
    const std::string path = prefix + field.name();
    if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
      DescribeFields(*field.message_type(), path + ".", out);
    } else {
      out += fmt::format("  {:<32} {}\n", path, field.type_name());
    }
  }
}

}  // namespace

void ConfigChecker::Range(std::string_view path, double value, double low, double high) {
  if (value >= low && value <= high) return;
  Report(path, fmt::format("{} is out of range [{}, {}]", value, low, high));
}

absl::Status ReadConfigText(const std::string& name, const std::string& text, google::protobuf::Message& config,
                            const std::function<void(ConfigChecker&)>& check) {
  std::vector<Problem> problems;
  ErrorCollector collector(problems);
  TextFormat::ParseInfoTree tree;
  TextFormat::Parser parser;
  parser.RecordErrorsTo(&collector);
  parser.AllowUnknownField(true);
  parser.WriteLocationsTo(&tree);
  const bool parsed = parser.ParseFromString(text, &config);
  if (!parsed && problems.empty()) problems.push_back({-1, "not a text proto"});
  LocatedChecker checker(*config.GetDescriptor(), tree, problems);
  if (const config::v1::RuntimeConfig* runtime = FindRuntime(config)) {
    CheckRuntime(*runtime, checker);
    if (runtime->has_tls()) CheckTls(runtime->tls(), checker);
    CheckExposure(*runtime, AsksForTokens(config), checker);
  }
  if (parsed && check) check(checker);
  return ToStatus(name, std::move(problems));
}

absl::Status ReadConfigFile(const std::string& path, google::protobuf::Message& config,
                            const std::function<void(ConfigChecker&)>& check) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file) text << file.rdbuf();
  // An empty file leaves failbit in `text`; only the file's own state tells of a failed read.
  if (!file || file.bad()) {
    return NotFound("{}: cannot read the config file: {}", path, std::strerror(errno));
  }
  return ReadConfigText(path, text.str(), config, check);
}

std::string DescribeConfig(const google::protobuf::Descriptor& descriptor) {
  std::string out;
  DescribeFields(descriptor, "", out);
  return out;
}

}  // namespace flair::runtime
