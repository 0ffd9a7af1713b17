// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {
namespace {

using v1::ArgumentValue;
using v1::ParameterSpec;

absl::Status WrongType(const ParameterSpec& spec, std::string_view wanted) {
  return absl::InvalidArgumentError(fmt::format("argument {}: give {}", spec.name(), wanted));
}

absl::StatusOr<int> ObjectIndex(const ParameterSpec& spec, const std::string& id, const Scene& scene) {
  const int index = scene.IndexOf(id);
  if (index < 0) return absl::NotFoundError(fmt::format("argument {}: there is no object \"{}\"", spec.name(), id));
  return index;
}

absl::StatusOr<Side> SideNamed(const ParameterSpec& spec, const std::string& text) {
  const std::optional<Side> side = SideFromName(text);
  if (side.has_value()) return *side;
  return absl::InvalidArgumentError(
      fmt::format("argument {}: \"{}\" is not a side; use front, back, left or right", spec.name(), text));
}

constexpr int kFeatureKinds = 3;
constexpr std::string_view kFeatureNames[kFeatureKinds] = {"door", "window", "socket"};

// The index that a text refers to; what it indexes depends on the kind.
absl::StatusOr<int> IndexOfText(const ParameterSpec& spec, const std::string& text, const Scene& scene) {
  switch (spec.kind()) {
    case v1::PARAMETER_KIND_OBJECT:
      return ObjectIndex(spec, text, scene);
    case v1::PARAMETER_KIND_ZONE: {
      const int zone = scene.ZoneIndexOf(text);
      if (zone >= 0) return zone;
      return absl::NotFoundError(fmt::format("argument {}: there is no zone \"{}\"", spec.name(), text));
    }
    case v1::PARAMETER_KIND_WALL: {
      const int wall = scene.room.WallIndex(text);
      if (wall >= 0) return wall;
      std::string names;
      for (const Wall& w : scene.room.walls) names += (names.empty() ? "" : ", ") + w.name;
      return absl::NotFoundError(
          fmt::format("argument {}: there is no wall \"{}\"; the room has {}", spec.name(), text, names));
    }
    case v1::PARAMETER_KIND_FEATURE:
      for (int kind = 0; kind < kFeatureKinds; ++kind) {
        if (text != kFeatureNames[kind]) continue;
        if (!FeatureSegments(scene.room, {static_cast<FeatureKind>(kind)}).empty()) return kind;
        return absl::FailedPreconditionError(fmt::format("argument {}: the room has no {}", spec.name(), text));
      }
      for (int i = 0; i < static_cast<int>(scene.room.openings.size()); ++i) {
        if (scene.room.openings[i].id == text) return kFeatureKinds + i;
      }
      return absl::InvalidArgumentError(
          fmt::format("argument {}: \"{}\" is not a feature; use door, window, socket or the id of a door or window",
                      spec.name(), text));
    case v1::PARAMETER_KIND_CORNER: {
      const std::optional<Corner> corner = CornerFromName(text);
      if (corner.has_value()) return static_cast<int>(*corner);
      return absl::InvalidArgumentError(
          fmt::format("argument {}: \"{}\" is not a corner; use back_left, back_right, front_right or front_left",
                      spec.name(), text));
    }
    default:
      return absl::InternalError("not a text");
  }
}

absl::StatusOr<double> NumberOf(const ParameterSpec& spec, const ArgumentValue& value) {
  if (value.value_case() != ArgumentValue::kNumber || !std::isfinite(value.number())) {
    return WrongType(spec, "a finite number");
  }
  const double x = value.number();
  if ((spec.has_min_number() && x < spec.min_number()) || (spec.has_max_number() && x > spec.max_number())) {
    return absl::InvalidArgumentError(fmt::format("argument {}: {} is out of range; use {} to {} {}", spec.name(), x,
                                                  spec.min_number(), spec.max_number(), spec.unit()));
  }
  return x;
}

const ParameterSpec* SpecOf(const v1::ConstraintType& type, const std::string& name) {
  for (const ParameterSpec& spec : type.parameters()) {
    if (spec.name() == name) return &spec;
  }
  return nullptr;
}

// Every argument is known and given once.
absl::Status CheckNames(const v1::ConstraintType& type, const v1::ConstraintEdge& edge) {
  for (int i = 0; i < edge.arguments_size(); ++i) {
    const std::string& name = edge.arguments(i).name();
    if (SpecOf(type, name) == nullptr) {
      std::string known;
      for (const ParameterSpec& spec : type.parameters()) known += (known.empty() ? "" : ", ") + spec.name();
      return absl::InvalidArgumentError(fmt::format("{} has no argument {}; it takes {}", type.name(), name, known));
    }
    for (int j = 0; j < i; ++j) {
      if (edge.arguments(j).name() == name) {
        return absl::InvalidArgumentError(fmt::format("argument {} is given twice", name));
      }
    }
  }
  return absl::OkStatus();
}

}  // namespace

// Openings have the numbers behind those of the kinds.
RoomFeature Arguments::Feature(std::string_view name) const {
  const int index = Get(name).indices[0];
  return index < kFeatureKinds ? RoomFeature{static_cast<FeatureKind>(index)}
                               : RoomFeature{FeatureKind::kDoor, index - kFeatureKinds};
}

std::string FeatureName(const Room& room, const RoomFeature& feature) {
  return feature.opening >= 0 ? room.openings[static_cast<size_t>(feature.opening)].id
                              : std::string(kFeatureNames[static_cast<int>(feature.kind)]);
}

std::vector<Segment> FeatureSegments(const Room& room, const RoomFeature& feature) {
  std::vector<Segment> segments;
  if (feature.kind == FeatureKind::kSocket) {
    for (const Socket& socket : room.sockets) segments.push_back(room.SegmentOf(socket));
    return segments;
  }
  const OpeningKind wanted = feature.kind == FeatureKind::kDoor ? OpeningKind::kDoor : OpeningKind::kWindow;
  for (int i = 0; i < static_cast<int>(room.openings.size()); ++i) {
    const Opening& opening = room.openings[static_cast<size_t>(i)];
    if (feature.opening < 0 ? opening.kind == wanted : feature.opening == i) segments.push_back(room.SegmentOf(opening));
  }
  return segments;
}

absl::StatusOr<Arguments::Value> Arguments::ResolveOne(const ParameterSpec& spec, const ArgumentValue& value,
                                                       const Scene& scene) {
  Value resolved;
  resolved.name = spec.name();
  resolved.kind = spec.kind();
  switch (spec.kind()) {
    case v1::PARAMETER_KIND_OBJECTS:
    case v1::PARAMETER_KIND_SIDES: {
      if (value.value_case() != ArgumentValue::kTexts || value.texts().items().empty()) {
        return WrongType(spec, "a list of at least one text");
      }
      for (const std::string& item : value.texts().items()) {
        if (spec.kind() == v1::PARAMETER_KIND_SIDES) {
          ASSIGN_OR_RETURN(const Side side, SideNamed(spec, item));
          if (std::find(resolved.sides.begin(), resolved.sides.end(), side) == resolved.sides.end()) {
            resolved.sides.push_back(side);
          }
        } else {
          ASSIGN_OR_RETURN(const int object, ObjectIndex(spec, item, scene));
          resolved.indices.push_back(object);
        }
      }
      return resolved;
    }
    case v1::PARAMETER_KIND_NUMBER: {
      ASSIGN_OR_RETURN(resolved.number, NumberOf(spec, value));
      return resolved;
    }
    case v1::PARAMETER_KIND_BOOLEAN:
      if (value.value_case() != ArgumentValue::kFlag) return WrongType(spec, "true or false");
      resolved.number = value.flag() ? 1 : 0;
      return resolved;
    default:
      break;
  }
  if (value.value_case() != ArgumentValue::kText) return WrongType(spec, "a text");
  if (spec.kind() == v1::PARAMETER_KIND_SIDE) {
    ASSIGN_OR_RETURN(const Side side, SideNamed(spec, value.text()));
    resolved.sides.push_back(side);
    return resolved;
  }
  ASSIGN_OR_RETURN(const int index, IndexOfText(spec, value.text(), scene));
  resolved.indices.push_back(index);
  return resolved;
}

absl::StatusOr<Arguments> Arguments::Resolve(const v1::ConstraintType& type, const v1::ConstraintEdge& edge,
                                             const Scene& scene) {
  RETURN_IF_ERROR(CheckNames(type, edge));
  Arguments arguments;
  for (const ParameterSpec& spec : type.parameters()) {
    const ArgumentValue* value = spec.has_default_value() ? &spec.default_value() : nullptr;
    for (const v1::Argument& argument : edge.arguments()) {
      if (argument.name() == spec.name()) value = &argument.value();
    }
    if (value == nullptr) {
      if (!spec.required()) continue;
      return absl::InvalidArgumentError(fmt::format("{} needs argument {}", type.name(), spec.name()));
    }
    ASSIGN_OR_RETURN(Value resolved, ResolveOne(spec, *value, scene));
    arguments.values_.push_back(std::move(resolved));
  }
  RETURN_IF_ERROR(arguments.CheckObjectsDiffer(scene));
  return arguments;
}

absl::Status Arguments::CheckObjectsDiffer(const Scene& scene) const {
  std::vector<int> all = AllObjects();
  std::sort(all.begin(), all.end());
  const auto twice = std::adjacent_find(all.begin(), all.end());
  if (twice == all.end()) return absl::OkStatus();
  return absl::InvalidArgumentError(
      fmt::format("object \"{}\" is named twice", scene.objects[static_cast<size_t>(*twice)].id));
}

const Arguments::Value* Arguments::Find(std::string_view name) const {
  for (const Value& value : values_) {
    if (value.name == name) return &value;
  }
  return nullptr;
}

const Arguments::Value& Arguments::Get(std::string_view name) const {
  static const Value kNone{"", v1::PARAMETER_KIND_UNSPECIFIED, {0}, {Side::kFront}, 0};
  const Value* value = Find(name);
  return value != nullptr ? *value : kNone;
}

std::optional<Side> Arguments::MaybeSide(std::string_view name) const {
  const Value* value = Find(name);
  return value != nullptr ? std::optional<Side>(value->sides[0]) : std::nullopt;
}

int Arguments::MaybeWall(std::string_view name) const { return MaybeObject(name); }

int Arguments::MaybeObject(std::string_view name) const {
  const Value* value = Find(name);
  return value != nullptr ? value->indices[0] : -1;
}

std::vector<int> Arguments::AllObjects() const {
  std::vector<int> all;
  for (const Value& value : values_) {
    if (value.kind != v1::PARAMETER_KIND_OBJECT && value.kind != v1::PARAMETER_KIND_OBJECTS) continue;
    all.insert(all.end(), value.indices.begin(), value.indices.end());
  }
  return all;
}

}  // namespace flair::optimizer
