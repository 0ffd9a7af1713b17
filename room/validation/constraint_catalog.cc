// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "room/validation/checks.h"

namespace flair::validation {
namespace {

void CheckParameter(const v1::ParameterSpec& parameter, const Field& at) {
  at["kind"].Enum(parameter.kind(), v1::ParameterKind_IsValid(parameter.kind()));
  at["doc"].Text(parameter.doc(), 0, 4000);
  const bool bounded = parameter.has_min_number() && parameter.has_max_number();
  if (bounded && !(parameter.min_number() <= parameter.max_number())) {
    at["min_number"].Reject("{} is above max_number {}", parameter.min_number(), parameter.max_number());
  }
  if (parameter.required() && parameter.has_default_value()) at["default_value"].Reject("is set, but it is required");
}

void CheckExample(const v1::CallExample& example, const NameSet& parameters, const Field& at) {
  at["sentence"].Text(example.sentence(), 1, 4000);
  for (int i = 0; i < example.arguments_size(); ++i) {
    at["arguments"][i]["name"].Refers(example.arguments(i).name(), parameters, "a parameter");
  }
}

}  // namespace

void Check(const v1::ConstraintCatalog& catalog, const Field& at) {
  at["library"].Text(catalog.library(), 1, 200);
  if (!at["types"].Count(catalog.types_size(), 1, 1000, "types")) return;
  NameSet names;  // aliases share them
  for (int i = 0; i < catalog.types_size(); ++i) at["types"][i]["name"].NewId(catalog.types(i).name(), names);
  for (int i = 0; i < catalog.types_size(); ++i) {
    const v1::ConstraintType& type = catalog.types(i);
    const Field field = at["types"][i];
    for (int k = 0; k < type.aliases_size(); ++k) {
      if (type.aliases(k) != type.name()) field["aliases"][k].NewId(type.aliases(k), names);
    }
    field["summary"].Text(type.summary(), 1, 4000);
    NameSet parameters;
    for (int k = 0; k < type.parameters_size(); ++k) {
      field["parameters"][k]["name"].NewId(type.parameters(k).name(), parameters);
      CheckParameter(type.parameters(k), field["parameters"][k]);
    }
    for (int k = 0; k < type.examples_size(); ++k) CheckExample(type.examples(k), parameters, field["examples"][k]);
  }
}

}  // namespace flair::validation
