// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/arguments.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "optimizer_worker/constraints/facts.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {
namespace {

using v1::ArgumentValue;
using v1::ParameterSpec;

absl::Status WrongType(const ParameterSpec& spec, std::string_view wanted) {
  return InvalidArgument("argument {}: give {}", spec.name(), wanted);
}

absl::StatusOr<int> ObjectIndex(const ParameterSpec& spec, const std::string& id, const Scene& scene) {
  const int index = scene.IndexOf(id);
  if (index < 0) return NotFound("argument {}: there is no object \"{}\"", spec.name(), id);
  return index;
}

absl::StatusOr<Side> SideNamed(const ParameterSpec& spec, const std::string& text) {
  const std::optional<Side> side = SideFromName(text);
  if (side.has_value()) return *side;
  return InvalidArgument("argument {}: \"{}\" is not a side; use front, back, left or right", spec.name(), text);
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
      return NotFound("argument {}: there is no zone \"{}\"", spec.name(), text);
    }
    case v1::PARAMETER_KIND_WALL: {
      const int wall = scene.room.WallIndex(text);
      if (wall >= 0) return wall;
      std::string names;
      for (const Wall& w : scene.room.walls) names += (names.empty() ? "" : ", ") + w.name;
      return NotFound("argument {}: there is no wall \"{}\"; the room has {}", spec.name(), text, names);
    }
    case v1::PARAMETER_KIND_FEATURE:
      for (int kind = 0; kind < kFeatureKinds; ++kind) {
        if (text != kFeatureNames[kind]) continue;
        if (!FeatureSegments(scene.room, {static_cast<FeatureKind>(kind)}).empty()) return kind;
        return FailedPrecondition("argument {}: the room has no {}", spec.name(), text);
      }
      for (int i = 0; i < static_cast<int>(scene.room.openings.size()); ++i) {
        if (scene.room.openings[i].id == text) return kFeatureKinds + i;
      }
      return InvalidArgument(
          "argument {}: \"{}\" is not a feature; use door, window, socket or the id of a door or window", spec.name(),
          text);
    case v1::PARAMETER_KIND_CORNER: {
      const std::optional<Corner> corner = CornerFromName(text);
      if (corner.has_value()) return static_cast<int>(*corner);
      return InvalidArgument(
          "argument {}: \"{}\" is not a corner; use back_left, back_right, front_right or front_left", spec.name(),
          text);
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
    return InvalidArgument("argument {}: {} is out of range; use {} to {} {}", spec.name(), x, spec.min_number(),
                           spec.max_number(), spec.unit());
  }
  return x;
}

const ParameterSpec* SpecOf(const v1::ConstraintType& type, const std::string& name) {
  const auto found = std::ranges::find(type.parameters(), name, &ParameterSpec::name);
  return found == type.parameters().end() ? nullptr : &*found;
}

// Every argument is known and given once.
absl::Status CheckNames(const v1::ConstraintType& type, const v1::ConstraintEdge& edge) {
  for (int i = 0; i < edge.arguments_size(); ++i) {
    const std::string& name = edge.arguments(i).name();
    if (SpecOf(type, name) == nullptr) {
      std::string known;
      for (const ParameterSpec& spec : type.parameters()) known += (known.empty() ? "" : ", ") + spec.name();
      return InvalidArgument("{} has no argument {}; it takes {}", type.name(), name, known);
    }
    for (int j = 0; j < i; ++j) {
      if (edge.arguments(j).name() == name) {
        return InvalidArgument("argument {} is given twice", name);
      }
    }
  }
  return absl::OkStatus();
}

// Of a type that only another optimizer knows: what the text looks like.
v1::ParameterKind KindByLooks(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  if (!text.empty() && *end == '\0') return v1::PARAMETER_KIND_NUMBER;
  if (text == "true" || text == "false") return v1::PARAMETER_KIND_BOOLEAN;
  return text.find(',') == std::string::npos ? v1::PARAMETER_KIND_OBJECT : v1::PARAMETER_KIND_OBJECTS;
}

v1::ParameterKind KindOf(const v1::ConstraintType& type, const std::string& name) {
  const ParameterSpec* const spec = SpecOf(type, name);
  return spec == nullptr ? v1::PARAMETER_KIND_UNSPECIFIED : spec->kind();
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

// Openings have the numbers behind those of the kinds.
RoomFeature Arguments::Feature(std::string_view name) const {
  const int index = Get(name).indices[0];
  return index < kFeatureKinds ? RoomFeature{static_cast<FeatureKind>(index)}
                               : RoomFeature{FeatureKind::kDoor, index - kFeatureKinds};
}

std::string FeatureName(const Room& room, const RoomFeature& feature) {
  return feature.opening >= 0 ? NameForPeople(room, room.openings[static_cast<size_t>(feature.opening)])
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
    if (feature.opening < 0 ? opening.kind == wanted : feature.opening == i)
      segments.push_back(room.SegmentOf(opening));
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
          if (std::ranges::find(resolved.sides, side) == resolved.sides.end()) {
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
  // "wall_2|wall_4": either.
  std::istringstream names(spec.kind() == v1::PARAMETER_KIND_WALL ? value.text() : "");
  for (std::string name; std::getline(names, name, '|');) {
    ASSIGN_OR_RETURN(const int wall, IndexOfText(spec, name, scene));
    resolved.indices.push_back(wall);
  }
  if (resolved.indices.empty()) {
    ASSIGN_OR_RETURN(const int index, IndexOfText(spec, value.text(), scene));
    resolved.indices.push_back(index);
  }
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
      return InvalidArgument("{} needs argument {}", type.name(), spec.name());
    }
    ASSIGN_OR_RETURN(Value resolved, ResolveOne(spec, *value, scene));
    arguments.values_.push_back(std::move(resolved));
  }
  RETURN_IF_ERROR(arguments.CheckObjectsDiffer(scene));
  return arguments;
}

absl::Status Arguments::CheckObjectsDiffer(const Scene& scene) const {
  std::vector<int> all = AllObjects();
  std::ranges::sort(all);
  const auto twice = std::ranges::adjacent_find(all);
  if (twice == all.end()) return absl::OkStatus();
  return InvalidArgument("object \"{}\" is named twice", scene.objects[static_cast<size_t>(*twice)].id);
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

std::vector<int> Arguments::Walls(std::string_view name) const {
  const Value* value = Find(name);
  return value != nullptr ? value->indices : std::vector<int>();
}

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
