// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps an object out of the space that a door, window or socket needs.
//   cost = sum over areas of depth^2                                                                         [m2]
//   areas  door: swing and passage (room/door_clear.h); window: its width, 0.5 m into the room; socket: 0.15 m wide,
//   0.1 m depth  shortest push out of the area that does not go through the wall
// Zero exactly when nothing is blocked. An object of known height that ends below a window's sill never blocks it. The
// released ind_not_block_fixed_object jumps at contact, ignores sockets and knows no heights (SEMANTICS.md section 3).
#include <fmt/format.h>

#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/convex_piece.h"
#include "optimizer_worker/constraints/measure/floor_shape.h"
#include "optimizer_worker/constraints/measure/gap.h"
#include "optimizer_worker/constraints/room/door_clear.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

namespace {

struct ClearOfFeature {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  std::vector<ConvexPiece> areas;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
    const Box<T> box(footprint, frames[0]);
    T sum(0.0);
    for (const ConvexPiece& area : areas) sum += SquaredPenetration<T>(box, area);
    return sum;
  }
};

constexpr double kWindowDepth_m = 0.5;
constexpr double kSocketWidth_m = 0.15;
constexpr double kSocketDepth_m = 0.1;

std::vector<ConvexPiece> WindowAreas(const Scene& scene, int object) {
  std::vector<ConvexPiece> areas;
  const bool height_known = scene.objects[static_cast<size_t>(object)].height_m > 0;
  for (const Opening& opening : scene.room.openings) {
    if (opening.kind != OpeningKind::kWindow) continue;
    if (height_known && scene.TopOf(object) <= opening.sill_height_m) continue;
    if (height_known && scene.BottomOf(object) >= opening.head_height_m) continue;
    areas.push_back(StripAtWall(scene.room.walls[static_cast<size_t>(opening.wall)], opening.offset_m,
                                opening.offset_m + opening.width_m, kWindowDepth_m));
  }
  return areas;
}

std::vector<ConvexPiece> SocketAreas(const Scene& scene) {
  std::vector<ConvexPiece> areas;
  for (const Socket& socket : scene.room.sockets) {
    areas.push_back(StripAtWall(scene.room.walls[static_cast<size_t>(socket.wall)],
                                socket.offset_m - kSocketWidth_m / 2, socket.offset_m + kSocketWidth_m / 2,
                                kSocketDepth_m));
  }
  return areas;
}

std::vector<ConvexPiece> AreasOf(const Scene& scene, int object, FeatureKind kind) {
  switch (kind) {
    case FeatureKind::kDoor:
      return DoorAreas(scene.room);
    case FeatureKind::kWindow:
      return WindowAreas(scene, object);
    case FeatureKind::kSocket:
      return SocketAreas(scene);
  }
  return {};
}

std::optional<Shortfall> ClearOfFeatureShortfall(const PlacedCall& call) {
  const double depth = call.CostRoot();
  return Worst(
      {{fmt::format("{} reaches {:.2f} m into the floor before {}", call.NameOf("object"), depth, call.FeatureName()),
        depth, "m"}});
}

}  // namespace

ConstraintFacts ClearOfFeatureFacts() {
  return {
      .name = "clear_of_feature",
      .aliases = {"ind_not_block_fixed_object", "io_not_block_fixed_object"},
      .family = "feature",
      .summary = "`object` does not block any door, window or socket.",
      .phrase = "blocks no {feature}",
      .doc =
          "cost = sum of squared penetration of the areas that the features need [m2]: swing and passage of a door, "
          "0.5 m "
          "in front of a window unless the object ends below the sill, a hand's width before a socket. The released "
          "function jumps at contact and ignores sockets.",
      .parameters = {ObjectParameter("object", "What must not block."),
                     FeatureParameter("feature", "What stays free.")},
      .sentences = {{"The wardrobe does not block the window.", "object=wardrobe feature=window"},
                    {"The sofa must not obstruct the door.", "object=sofa feature=door"}},
      .layouts = {Satisfied("4x3 room; window south 1 1; shelf 1x0.3 at 2.5,0.15,0 height 2",
                            "object=shelf feature=window"),
                  Satisfied("4x3 room; window south 1 1 sill 0.9; desk 1x0.6 at 1.5,0.3,0 height 0.75",
                            "object=desk feature=window"),
                  Violated("4x3 room; window south 1 1 sill 0.9; shelf 1x0.3 at 1.7,0.3,8 height 2",
                           "object=shelf feature=window"),
                  Violated("4x3 room; socket south 1; shelf 1x0.3 at 1.2,0.15,0 height 2",
                           "object=shelf feature=socket"),
                  Violated("4x3 room; door south 1 0.9; shelf 1x0.3 at 1.2,0.6,15", "object=shelf feature=door")},
      .shortfall = ClearOfFeatureShortfall,
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        return MakeCost(
            ClearOfFeature{FootprintOf(context, object), AreasOf(context.scene, object, a.Feature("feature"))},
            {object});
      }};
}

}  // namespace flair::optimizer
