// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "fmt/format.h"
#include "translator_worker/catalog/catalog_source.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::translator {
namespace {

using Value = v1::ArgumentValue;

// Whether a value has the form that a kind of parameter needs.
bool HasForm(v1::ParameterKind kind, Value::ValueCase form) {
  switch (kind) {
    case v1::PARAMETER_KIND_OBJECTS:
    case v1::PARAMETER_KIND_SIDES:
      return form == Value::kTexts;
    case v1::PARAMETER_KIND_NUMBER:
      return form == Value::kNumber;
    case v1::PARAMETER_KIND_BOOLEAN:
      return form == Value::kFlag;
    default:
      return form == Value::kText;
  }
}

const v1::ParameterSpec* FindParameter(const v1::ConstraintType& type, const std::string& name) {
  for (const v1::ParameterSpec& parameter : type.parameters()) {
    if (parameter.name() == name) return &parameter;
  }
  return nullptr;
}

void Clamp(const v1::ParameterSpec& parameter, Value& value, std::vector<std::string>& remarks) {
  double number = value.number();
  if (parameter.has_min_number()) number = std::max(number, parameter.min_number());
  if (parameter.has_max_number()) number = std::min(number, parameter.max_number());
  if (number == value.number()) return;
  remarks.push_back(fmt::format("{} {} {} is out of range; {} was taken", parameter.name(), value.number(),
                                parameter.unit(), number));
  value.set_number(number);
}

}  // namespace

CatalogIndex::CatalogIndex(const v1::ConstraintCatalog& catalog) {
  for (const v1::ConstraintType& type : catalog.types()) {
    if (type.built_in()) continue;
    for (const std::string& alias : type.aliases()) types_.emplace(alias, &type);
  }
  for (const v1::ConstraintType& type : catalog.types()) {
    if (!type.built_in()) types_[type.name()] = &type;
  }
}

const v1::ConstraintType* CatalogIndex::Find(const std::string& name) const {
  const auto found = types_.find(name);
  return found == types_.end() ? nullptr : found->second;
}

absl::Status CatalogIndex::Fit(const v1::ConstraintType& type, std::vector<v1::Argument>& arguments,
                               std::vector<std::string>& remarks) {
  std::erase_if(arguments, [&](const v1::Argument& argument) { return !FindParameter(type, argument.name()); });
  for (v1::Argument& argument : arguments) {
    const v1::ParameterSpec& parameter = *FindParameter(type, argument.name());
    if (!HasForm(parameter.kind(), argument.value().value_case())) {
      return InvalidArgument("{}.{} has another form in the catalogue", type.name(), argument.name());
    }
    if (parameter.kind() == v1::PARAMETER_KIND_NUMBER) Clamp(parameter, *argument.mutable_value(), remarks);
  }
  for (const v1::ParameterSpec& parameter : type.parameters()) {
    const bool given = std::ranges::any_of(
        arguments, [&](const v1::Argument& argument) { return argument.name() == parameter.name(); });
    if (parameter.required() && !given) {
      return InvalidArgument("{} needs {}", type.name(), parameter.name());
    }
  }
  return absl::OkStatus();
}

}  // namespace flair::translator
