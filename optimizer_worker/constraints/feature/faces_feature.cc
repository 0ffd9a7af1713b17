// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/feature/faces_feature.h"

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/measure/choose.h"

namespace flair::optimizer {

template <typename T>
T FacesFeature::operator()(const Frames<T, 1>& frames) const {
  return LeastOf<T>(features, frames, [](const Segment& feature, const auto& f) {
    using S = std::decay_t<decltype(f[0].center.x)>;
    const Vec2<S> start = f[0].ToObject(Cast<S>(feature.start));
    const Vec2<S> end = f[0].ToObject(Cast<S>(feature.end));
    return SquaredHinge(end.x) + SquaredHinge(-start.x) + SquaredHinge(S(-0.5) * (start.y + end.y));
  });
}

namespace {

std::vector<Segment> Targets(const Room& room, FeatureKind kind) {
  std::vector<Segment> targets = FeatureSegments(room, kind);
  if (kind != FeatureKind::kSocket) return targets;
  constexpr double kHalfWidth_m = 0.15;
  for (size_t i = 0; i < targets.size(); ++i) {
    const Vec2<double> along = room.walls[static_cast<size_t>(room.sockets[i].wall)].Along();
    targets[i].start = targets[i].start - kHalfWidth_m * along;
    targets[i].end = targets[i].end + kHalfWidth_m * along;
  }
  return targets;
}

}  // namespace

ConstraintFacts FacesFeatureFacts() {
  return {
      .name = "faces_feature",
      .family = "feature",
      .summary = "`object` looks towards a door, window or socket: the line straight ahead of it meets the feature.",
      .doc =
          "cost = min over features of the squared distances by which its two ends are on the wrong side of the line "
          "of "
          "sight, and of being behind [m2].",
      .parameters = {ObjectParameter("object", "What looks."), FeatureParameter("feature", "At what.")},
      .sentences = {{"The armchair faces the window.", "object=armchair feature=window"},
                    {"The easel is turned towards the window.", "object=easel feature=window"}},
      .layouts = {Satisfied("4x3 room; window north 1 1; chair 0.6x0.6 at 2.5,1,0", "object=chair feature=window"),
                  Violated("4x3 room; window north 1 1; chair 0.6x0.6 at 2.5,1,40", "object=chair feature=window"),
                  Violated("4x3 room; window north 1 1; chair 0.6x0.6 at 2.5,1,180", "object=chair feature=window")},
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        return MakeCost(FacesFeature{Targets(context.scene.room, a.Feature("feature"))}, {a.Object("object")});
      }};
}

}  // namespace flair::optimizer
