// SPDX-License-Identifier: GPL-3.0-or-later
// The arguments of a call: after checking, with names resolved to indices and defaults filled in; and as short text.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/constraint_catalog.pb.h"
#include "flair/v1/layout_graph.pb.h"
#include "room/geometry/polygon.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

// What a call may point at in a room besides its walls.
enum class FeatureKind { kDoor, kWindow, kSocket };

// All of a kind, or the one door or window that is meant.
struct RoomFeature {
  FeatureKind kind = FeatureKind::kDoor;
  // Index in Room::openings; -1 for all.
  int opening = -1;

  bool Includes(int i) const { return opening < 0 || opening == i; }
};

// "door", or the id of the one that is meant.
std::string FeatureName(const Room& room, const RoomFeature& feature);

class Arguments {
 public:
  // Checks all arguments of `edge` against the parameters of its type. Unset optional ones without default stay unset.
  static absl::StatusOr<Arguments> Resolve(const v1::ConstraintType& type, const v1::ConstraintEdge& edge,
                                           const Scene& scene);

  // Only for parameters that the type declares with that kind and that are required or have a default.
  int Object(std::string_view name) const { return Get(name).indices[0]; }
  const std::vector<int>& Objects(std::string_view name) const { return Get(name).indices; }
  int Zone(std::string_view name) const { return Get(name).indices[0]; }
  RoomFeature Feature(std::string_view name) const;
  Side OneSide(std::string_view name) const { return Get(name).sides[0]; }
  const std::vector<Side>& Sides(std::string_view name) const { return Get(name).sides; }
  Corner OneCorner(std::string_view name) const { return static_cast<Corner>(Get(name).indices[0]); }
  double Number(std::string_view name) const { return Get(name).number; }
  bool Flag(std::string_view name) const { return Get(name).number != 0; }

  // For those that may stay unset.
  bool Has(std::string_view name) const { return Find(name) != nullptr; }
  std::optional<Side> MaybeSide(std::string_view name) const;
  // Any of which it may be; none when unset.
  std::vector<int> Walls(std::string_view name) const;
  // -1 when unset.
  int MaybeObject(std::string_view name) const;
  double NumberOr(std::string_view name, double otherwise) const { return Has(name) ? Number(name) : otherwise; }

  // All objects named in any argument, in call order.
  std::vector<int> AllObjects() const;

 private:
  struct Value {
    std::string name;
    v1::ParameterKind kind = v1::PARAMETER_KIND_UNSPECIFIED;
    std::vector<int> indices;
    std::vector<Side> sides;
    double number = 0;
  };

  const Value* Find(std::string_view name) const;
  const Value& Get(std::string_view name) const;
  absl::Status CheckObjectsDiffer(const Scene& scene) const;
  static absl::StatusOr<Value> ResolveOne(const v1::ParameterSpec& spec, const v1::ArgumentValue& value,
                                          const Scene& scene);

  std::vector<Value> values_;
};

// Where it is on the walls, in the room's order: empty when there is none.
std::vector<Segment> FeatureSegments(const Room& room, const RoomFeature& feature);

// Calls as short text, for the examples in facts and for tests: "object=bed side=back", "center=table objects=a,b,c",
// "object=sofa distance_m=0.5 parallel=false".

// Arguments typed as the type's parameters say; an unknown name becomes a text, so that the checks can report it.
std::vector<v1::Argument> ArgumentsFromText(const v1::ConstraintType& type, std::string_view call);

// The type of call that "near", as a word of somebody who edits a layout, stands for; its arguments are object and
// target.
inline constexpr char kNearCall[] = "near";

// An edge of that type with those arguments and weight 1. The type may be an alias; of one that only another optimizer
// knows, the arguments are what they look like: a number, true or false, several names with commas between, or a name.
v1::ConstraintEdge EdgeFromText(std::string_view type, std::string_view call);

}  // namespace flair::optimizer
