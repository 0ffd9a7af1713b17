// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/call_text.h"

#include "fmt/format.h"
#include "fmt/ranges.h"

namespace flair::cli {

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

std::string CallText(const std::string& type, const google::protobuf::RepeatedPtrField<v1::Argument>& arguments) {
  std::string text;
  for (const v1::Argument& argument : arguments) {
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", argument.name(), ValueText(argument.value()));
  }
  return fmt::format("{}({})", type, text);
}

std::string CallText(const v1::ConstraintEdge& edge) {
  const std::string weight = edge.weight() == 1 ? "" : fmt::format(" x {:g}", edge.weight());
  return CallText(edge.type(), edge.arguments()) + weight;
}

}  // namespace flair::cli
