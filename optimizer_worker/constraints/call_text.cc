// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <sstream>

#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/facts.h"

namespace flair::optimizer {
namespace {

// Of a type that only another optimizer knows: what the text looks like.
v1::ParameterKind KindByLooks(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  if (!text.empty() && *end == '\0') return v1::PARAMETER_KIND_NUMBER;
  if (text == "true" || text == "false") return v1::PARAMETER_KIND_BOOLEAN;
  return text.find(',') == std::string::npos ? v1::PARAMETER_KIND_OBJECT : v1::PARAMETER_KIND_OBJECTS;
}

v1::ParameterKind KindOf(const v1::ConstraintType& type, const std::string& name) {
  for (const v1::ParameterSpec& spec : type.parameters()) {
    if (spec.name() == name) return spec.kind();
  }
  return v1::PARAMETER_KIND_UNSPECIFIED;
}

v1::ArgumentValue ValueFromText(v1::ParameterKind kind, const std::string& text) {
  v1::ArgumentValue value;
  switch (kind) {
    case v1::PARAMETER_KIND_OBJECTS:
    case v1::PARAMETER_KIND_SIDES: {
      std::istringstream items(text);
      value.mutable_texts();
      for (std::string item; std::getline(items, item, ',');) value.mutable_texts()->add_items(item);
      break;
    }
    case v1::PARAMETER_KIND_NUMBER:
      value.set_number(std::strtod(text.c_str(), nullptr));
      break;
    case v1::PARAMETER_KIND_BOOLEAN:
      value.set_flag(text == "true");
      break;
    default:
      value.set_text(text);
  }
  return value;
}

std::vector<v1::Argument> Parse(const v1::ConstraintType* type, std::string_view call) {
  std::vector<v1::Argument> arguments;
  std::istringstream words{std::string(call)};
  for (std::string word; words >> word;) {
    const size_t equals = word.find('=');
    v1::Argument& argument = arguments.emplace_back();
    argument.set_name(word.substr(0, equals));
    const std::string text = equals == std::string::npos ? "" : word.substr(equals + 1);
    *argument.mutable_value() =
        ValueFromText(type != nullptr ? KindOf(*type, argument.name()) : KindByLooks(text), text);
  }
  return arguments;
}

}  // namespace

std::vector<v1::Argument> ArgumentsFromText(const v1::ConstraintType& type, std::string_view call) {
  return Parse(&type, call);
}

v1::ConstraintEdge EdgeFromText(std::string_view type, std::string_view call) {
  v1::ConstraintEdge edge;
  edge.set_id("e1");
  edge.set_type(std::string(type));
  edge.set_weight(1);
  const ConstraintFacts* const facts = FindConstraint(type);
  for (v1::Argument& argument : Parse(facts != nullptr ? &facts->type : nullptr, call)) {
    *edge.add_arguments() = std::move(argument);
  }
  return edge;
}

}  // namespace flair::optimizer
