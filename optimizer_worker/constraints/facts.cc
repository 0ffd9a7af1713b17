// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/facts.h"

#include <utility>

namespace flair::optimizer {

namespace {

v1::ParameterSpec Parameter(std::string name, v1::ParameterKind kind, std::string doc, bool required) {
  v1::ParameterSpec spec;
  spec.set_name(std::move(name));
  spec.set_kind(kind);
  spec.set_doc(std::move(doc));
  spec.set_required(required);
  return spec;
}

}  // namespace

v1::ParameterSpec ObjectParameter(std::string name, std::string doc) {
  return Parameter(std::move(name), v1::PARAMETER_KIND_OBJECT, std::move(doc), true);
}

v1::ParameterSpec ObjectsParameter(std::string name, std::string doc) {
  return Parameter(std::move(name), v1::PARAMETER_KIND_OBJECTS, std::move(doc), true);
}

v1::ParameterSpec ZoneParameter(std::string name, std::string doc) {
  return Parameter(std::move(name), v1::PARAMETER_KIND_ZONE, std::move(doc), true);
}

v1::ParameterSpec FeatureParameter(std::string name, std::string doc) {
  return Parameter(std::move(name), v1::PARAMETER_KIND_FEATURE, std::move(doc), true);
}

v1::ParameterSpec OptionalWall(std::string name, std::string doc) {
  return Parameter(std::move(name), v1::PARAMETER_KIND_WALL, std::move(doc), false);
}

v1::ParameterSpec OptionalObject(std::string name, std::string doc) {
  return Parameter(std::move(name), v1::PARAMETER_KIND_OBJECT, std::move(doc), false);
}

v1::ParameterSpec OptionalSide(std::string name, std::string doc) {
  return Parameter(std::move(name), v1::PARAMETER_KIND_SIDE, std::move(doc), false);
}

v1::ParameterSpec SideParameter(std::string name, std::string doc, Side default_side) {
  v1::ParameterSpec spec = OptionalSide(std::move(name), std::move(doc));
  spec.mutable_default_value()->set_text(std::string(SideName(default_side)));
  return spec;
}

v1::ParameterSpec SidesParameter(std::string name, std::string doc, std::vector<Side> default_sides) {
  v1::ParameterSpec spec = Parameter(std::move(name), v1::PARAMETER_KIND_SIDES, std::move(doc), false);
  for (Side side : default_sides) {
    spec.mutable_default_value()->mutable_texts()->add_items(std::string(SideName(side)));
  }
  return spec;
}

v1::ParameterSpec CornerParameter(std::string name, std::string doc, Corner default_corner) {
  v1::ParameterSpec spec = Parameter(std::move(name), v1::PARAMETER_KIND_CORNER, std::move(doc), false);
  spec.mutable_default_value()->set_text(std::string(CornerName(default_corner)));
  return spec;
}

v1::ParameterSpec LengthParameter(std::string name, std::string doc, double min_m, double max_m, double default_m) {
  v1::ParameterSpec spec = Parameter(std::move(name), v1::PARAMETER_KIND_NUMBER, std::move(doc), false);
  spec.set_unit("m");
  spec.set_min_number(min_m);
  spec.set_max_number(max_m);
  spec.mutable_default_value()->set_number(default_m);
  return spec;
}

v1::ParameterSpec FlagParameter(std::string name, std::string doc, bool default_flag) {
  v1::ParameterSpec spec = Parameter(std::move(name), v1::PARAMETER_KIND_BOOLEAN, std::move(doc), false);
  spec.mutable_default_value()->set_flag(default_flag);
  return spec;
}

// Every type's facts, from its own file.
#define CONSTRAINT(family, Type, file) ConstraintFacts Type##Facts();
#include "optimizer_worker/constraints/constraint_list.inc"
#undef CONSTRAINT

ConstraintLibrary OurLibrary() {
  return {.program = "flair-optimizer",
          .version = "1",
          .types = {
#define CONSTRAINT(family, Type, file) Type##Facts(),
#include "optimizer_worker/constraints/constraint_list.inc"
#undef CONSTRAINT
          }};
}

}  // namespace flair::optimizer
