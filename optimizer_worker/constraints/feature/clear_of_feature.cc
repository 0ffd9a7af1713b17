// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/feature/clear_of_feature.h"

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/gap.h"
#include "optimizer_worker/constraints/measure/room_areas.h"
#include "optimizer_worker/constraints/room/door_clear.h"

namespace flair::optimizer {

template <typename T>
T ClearOfFeature::operator()(const Frames<T, 1>& frames) const {
  const Box<T> box(footprint, frames[0]);
  T sum(0.0);
  for (const ConvexPiece& area : areas) sum += SquaredPenetration<T>(box, area);
  return sum;
}

namespace {

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

}  // namespace

ConstraintFacts ClearOfFeatureFacts() {
  return {
      .name = "clear_of_feature",
      .aliases = {"ind_not_block_fixed_object", "io_not_block_fixed_object"},
      .family = "feature",
      .summary = "`object` does not block any door, window or socket.",
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
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        const int object = a.Object("object");
        return MakeCost(
            ClearOfFeature{FootprintOf(context, object), AreasOf(context.scene, object, a.Feature("feature"))},
            {object});
      }};
}

}  // namespace flair::optimizer
