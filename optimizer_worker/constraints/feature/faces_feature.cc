// SPDX-License-Identifier: GPL-3.0-or-later
// Turns an object towards a door, window or socket.
//   cost = min over features of  max(u_end, 0)^2 + max(-u_start, 0)^2 + max(-v, 0)^2                          [m2]
//   u_start, u_end  how far right of the object's line of sight the feature's two ends are (the start is on the right
//   as seen
//                   from the room);  v  how far ahead its middle is
// Zero exactly when the straight look ahead meets the feature. A socket is taken 0.3 m wide.
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {

namespace {

struct FacesFeature {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  std::vector<Segment> features;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const {
    return LeastOf<T>(features, frames, [](const Segment& feature, const auto& f) {
      using S = std::decay_t<decltype(f[0].center.x)>;
      const Vec2<S> start = f[0].ToObject(Cast<S>(feature.start));
      const Vec2<S> end = f[0].ToObject(Cast<S>(feature.end));
      return SquaredHinge(end.x) + SquaredHinge(-start.x) + SquaredHinge(S(-0.5) * (start.y + end.y));
    });
  }
};

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

std::optional<Shortfall> FacesFeatureShortfall(const PlacedCall& call) {
  const Frame<double> frame = call.FrameOf(call.object());
  double least = kPi;
  for (const Segment& s : FeatureSegments(call.scene().room, call.arguments().Feature("feature"))) {
    const Vec2<double> start = frame.ToObject(s.start), end = frame.ToObject(s.end);
    if (end.x <= 0 && start.x >= 0 && start.y + end.y >= 0) return std::nullopt;
    least = std::min({least, AngleOf(frame.front, s.start - frame.center), AngleOf(frame.front, s.end - frame.center)});
  }
  return Worst({Turned(SideOf(call.NameOf("object"), Side::kFront), call.FeatureName(), least)});
}

}  // namespace

ConstraintFacts FacesFeatureFacts() {
  return {
      .name = "faces_feature",
      .family = "feature",
      .summary = "`object` looks towards a door, window or socket: the line straight ahead of it meets the feature.",
      .phrase = "looks at a {feature}",
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
      .shortfall = FacesFeatureShortfall,
      .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
        return MakeCost(FacesFeature{Targets(context.scene.room, a.Feature("feature"))}, {a.Object("object")});
      }};
}

}  // namespace flair::optimizer
