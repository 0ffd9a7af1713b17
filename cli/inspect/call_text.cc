// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/inspect/call_text.h"

#include "fmt/format.h"
#include "fmt/ranges.h"

namespace flair::cli {
namespace {

std::string ValueText(const v1::ArgumentValue& value) {
  switch (value.value_case()) {
    case v1::ArgumentValue::kText:
      return value.text();
    case v1::ArgumentValue::kTexts:
      return fmt::format("[{}]", fmt::join(value.texts().items(), ", "));
    case v1::ArgumentValue::kNumber:
      return fmt::format("{:g}", value.number());
    case v1::ArgumentValue::kFlag:
      return value.flag() ? "true" : "false";
    case v1::ArgumentValue::VALUE_NOT_SET:
      break;
  }
  return "?";
}

}  // namespace

std::string CallText(const v1::ConstraintEdge& edge) {
  std::string arguments;
  for (const v1::Argument& argument : edge.arguments()) {
    arguments += fmt::format("{}{}={}", arguments.empty() ? "" : ", ", argument.name(), ValueText(argument.value()));
  }
  const std::string weight = edge.weight() == 1 ? "" : fmt::format(" x {:g}", edge.weight());
  return fmt::format("{}({}){}", edge.type(), arguments, weight);
}

}  // namespace flair::cli
