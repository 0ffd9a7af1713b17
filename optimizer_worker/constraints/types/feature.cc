// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <vector>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/choose.h"
#include "optimizer_worker/constraints/measure/floor_shape.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "room/geometry/convex_piece.h"
#include "room/geometry/gap.h"
#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"
#include "room/scene/room.h"

namespace flair::optimizer {
namespace {

// Keeps an object away from all doors, windows or sockets.
//   cost = sum over features of that kind of  max(min - gap, 0)^2                                            [m2]
//   gap  signed gap between the rectangle and the feature's interval on the wall
// Zero exactly when every one is at least min_distance_m away. The released ind_away_from_fixed_object measures from
// centre to hinge less half a diagonal (SEMANTICS.md section 3).
std::vector<ConvexPiece> PiecesOf(const Room& room, const RoomFeature& feature) {
  std::vector<ConvexPiece> pieces;
  for (const Segment& s : FeatureSegments(room, feature)) pieces.emplace_back(s);
  return pieces;
}

std::optional<Shortfall> AwayFromFeatureShortfall(const PlacedCall& call) {
  return Worst({TooNear(call.NameOf("object"), call.FeatureName(), call.NearestFeatureGap(),
                        call.arguments().Number("min_distance_m"))});
}

BoundCost BindAwayFromFeature(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object");
  const auto formula =
      [footprint = FootprintOf(context, object), min_m = a.Number("min_distance_m"),
       features = PiecesOf(context.scene.room, a.Feature("feature"))]<typename T>(const Frames<T, 1>& frames) {
        const Box<T> box(footprint, frames[0]);
        T sum(0.0);
        for (const ConvexPiece& feature : features) sum += SquaredNearness<T>(box, feature, min_m);
        return sum;
      };
  return MakeCost<kSeesZero>({object}, formula);
}

// Keeps an object out of the space that a door, window or socket needs.
//   cost = sum over areas of depth^2                                                                         [m2]
//   areas  door: swing and 1.2 m of passage (DoorAreas), for one steps in; window: its width, 0.5 m into the room;
//          socket: 0.15 m wide, 0.1 m deep
//   depth  shortest push out of the area that does not go through the wall
// Zero exactly when nothing is blocked. An object of known height that ends below a window's sill never blocks it. The
// released ind_not_block_fixed_object jumps at contact, ignores sockets and knows no heights (SEMANTICS.md section 3).
constexpr double kStepIn_m = 1.2;
constexpr double kWindowDepth_m = 0.5;
constexpr double kSocketWidth_m = 0.15;
constexpr double kSocketDepth_m = 0.1;

std::vector<ConvexPiece> WindowAreas(const Scene& scene, int object, const RoomFeature& feature) {
  std::vector<ConvexPiece> areas;
  const bool height_known = scene.objects[static_cast<size_t>(object)].height_m > 0;
  for (int i = 0; i < static_cast<int>(scene.room.openings.size()); ++i) {
    const Opening& opening = scene.room.openings[static_cast<size_t>(i)];
    if (opening.kind != OpeningKind::kWindow || !feature.Includes(i)) continue;
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

std::vector<ConvexPiece> AreasOf(const Scene& scene, int object, const RoomFeature& feature) {
  if (feature.opening >= 0) {
    const Opening& opening = scene.room.openings[static_cast<size_t>(feature.opening)];
    if (opening.kind == OpeningKind::kWindow) return WindowAreas(scene, object, feature);
    Room alone = scene.room;
    alone.openings = {opening};
    return DoorAreas(alone, kStepIn_m);
  }
  switch (feature.kind) {
    case FeatureKind::kDoor:
      return DoorAreas(scene.room, kStepIn_m);
    case FeatureKind::kWindow:
      return WindowAreas(scene, object, feature);
    case FeatureKind::kSocket:
      return SocketAreas(scene);
  }
  return {};
}

// How much floor a feature needs.
double NeededBefore_m(const Room& room, const RoomFeature& feature) {
  const bool opening = feature.opening >= 0;
  const bool window = opening ? room.openings[static_cast<size_t>(feature.opening)].kind == OpeningKind::kWindow
                              : feature.kind == FeatureKind::kWindow;
  return window ? kWindowDepth_m : opening || feature.kind == FeatureKind::kDoor ? kStepIn_m : kSocketDepth_m;
}

std::optional<Shortfall> ClearOfFeatureShortfall(const PlacedCall& call) {
  const double depth = call.CostRoot(),
               needed_m = NeededBefore_m(call.scene().room, call.arguments().Feature("feature"));
  return Worst({{fmt::format("{} reaches {:.2f} m into the {:.2f} m of floor that is to be free before {}",
                             call.NameOf("object"), depth, needed_m, call.FeatureName()),
                 depth, "m"}});
}

BoundCost BindClearOfFeature(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object");
  return ClearOfAreas(object, FootprintOf(context, object), AreasOf(context.scene, object, a.Feature("feature")));
}

// Keeps an object, or one of its sides, close to a door, window or socket.
//   cost = min over features of that kind of  max(d - max, 0)^2                                              [m2]
//   d  distance between the rectangle (or the side) and the feature's interval on the wall
// Zero exactly when some feature is within max_distance_m. The released ind_close_to_fixed_object measures to a door's
// hinge and does not square the excess (SEMANTICS.md section 3).
std::optional<Shortfall> CloseToFeatureShortfall(const PlacedCall& call) {
  return Worst({TooFar(call.NameOf("object"), call.FeatureName(), call.NearestFeatureGap(),
                       call.arguments().Number("max_distance_m"))});
}

BoundCost BindCloseToFeature(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object");
  const auto formula =
      [footprint = FootprintOf(context, object), side = a.MaybeSide("side"), max_m = a.Number("max_distance_m"),
       features = PiecesOf(context.scene.room, a.Feature("feature"))]<typename T>(const Frames<T, 1>& frames) {
        return LeastOf<T>(features, frames, [&](const ConvexPiece& feature, const auto& f) {
          using S = std::decay_t<decltype(f[0].center.x)>;
          if (!side.has_value()) return SquaredDistanceBeyond<S>(Box<S>(footprint, f[0]), feature, max_m);
          return SquaredDistanceBeyond<S>(Box<S>::Before(footprint, f[0], *side, 0), feature, max_m);
        });
      };
  return MakeCost<kSeesZero>({object}, formula);
}

// Turns an object towards a door, window or socket.
//   cost = min over features of  max(u_end, 0)^2 + max(-u_start, 0)^2 + max(-v, 0)^2                          [m2]
//   u_start, u_end  how far right of the object's line of sight the feature's two ends are (the start is on the right
//   as seen
//                   from the room);  v  how far ahead its middle is
// Zero exactly when the straight look ahead meets the feature. A socket is taken 0.3 m wide.
std::vector<Segment> Targets(const Room& room, const RoomFeature& feature) {
  std::vector<Segment> targets = FeatureSegments(room, feature);
  if (feature.kind != FeatureKind::kSocket) return targets;
  constexpr double kHalfWidth_m = 0.15;
  for (size_t i = 0; i < targets.size(); ++i) {
    const Vec2<double> along = room.walls[static_cast<size_t>(room.sockets[i].wall)].Along();
    targets[i].start = targets[i].start - kHalfWidth_m * along;
    targets[i].end = targets[i].end + kHalfWidth_m * along;
  }
  return targets;
}

template <Look kLook>
std::optional<Shortfall> FacesFeatureShortfall(const PlacedCall& call) {
  const Frame<double> frame = LookOf(call.FrameOf(call.object()), kLook);
  double least = kPi;
  for (const Segment& s : FeatureSegments(call.scene().room, call.arguments().Feature("feature"))) {
    const Vec2<double> start = frame.ToObject(s.start), end = frame.ToObject(s.end);
    if (end.x <= 0 && start.x >= 0 && start.y + end.y >= 0) return std::nullopt;
    least = std::min({least, AngleOf(frame.front, s.start - frame.center), AngleOf(frame.front, s.end - frame.center)});
  }
  return Worst({Turned(WhoLooks(call, call.object(), kLook), call.FeatureName(), least)});
}

template <Look kLook>
BoundCost BindFacesFeature(const Arguments& a, const BindContext& context) {
  const auto formula = [features =
                            Targets(context.scene.room, a.Feature("feature"))]<typename T>(const Frames<T, 1>& frames) {
    return LeastOf<T>(features, frames, [](const Segment& feature, const auto& f) {
      using S = std::decay_t<decltype(f[0].center.x)>;
      const Frame<S> look = LookOf(f[0], kLook);
      const Vec2<S> start = look.ToObject(Cast<S>(feature.start));
      const Vec2<S> end = look.ToObject(Cast<S>(feature.end));
      return SquaredHinge(end.x) + SquaredHinge(-start.x) + SquaredHinge(S(-0.5) * (start.y + end.y));
    });
  };
  return MakeCost<kSeesZero>({a.Object("object")}, formula);
}

// Puts an object under a window.
//   cost = min over windows of  out(gap, [0, 0.1])^2 + max(|offset| - |L - w| / 2, 0)^2 + (1 - cos a)          [m2]
//   gap     distance of the object's side that looks at the wall, offset  of that side's middle from the window's
//   middle L, w    lengths of that side and of the window;  a  angle between side and wall
// Zero exactly when the object stands at the wall (within 10 cm), square to it, its side within the window's interval
// or the other way round. The released ind_under_window reaches zero only with the centre on the wall (SEMANTICS.md
// section 3).

// A window as an interval of its wall.
struct WindowPlace {
  Wall wall;
  double middle_m;
  double width_m;
};

BoundCost BindUnderWindow(const Arguments& a, const BindContext& context) {
  const int object = a.Object("object");
  std::vector<WindowPlace> windows;
  const RoomFeature feature = a.Has("feature") ? a.Feature("feature") : RoomFeature{FeatureKind::kWindow};
  for (int i = 0; i < static_cast<int>(context.scene.room.openings.size()); ++i) {
    const Opening& o = context.scene.room.openings[static_cast<size_t>(i)];
    if (o.kind != OpeningKind::kWindow || !feature.Includes(i)) continue;
    windows.push_back({context.scene.room.walls[static_cast<size_t>(o.wall)], o.offset_m + o.width_m / 2, o.width_m});
  }
  if (windows.empty()) return absl::FailedPreconditionError("the room has no window");
  const auto formula = [footprint = FootprintOf(context, object), windows]<typename T>(const Frames<T, 1>& frames) {
    return LeastOf<T>(windows, frames, [&](const WindowPlace& window, const auto& f) {
      constexpr double kAir_m = 0.1;
      const Side side = SideTowards(ValueOf(f[0].front), window.wall);
      const auto middle = MiddleOf(footprint, f[0], side);
      const double play = std::abs(SideLength(footprint, side) - window.width_m) / 2;
      return SquaredOutside(window.wall.Height(middle), 0, kAir_m) +
             SquaredOutside(window.wall.Offset(middle) - window.middle_m, -play, play) +
             TurnToWall(f[0], side, window.wall);
    });
  };
  return MakeCost<kSeesZero>({object}, formula);
}

constexpr ConstraintCode kFeatureCode[] = {
    {"away_from_feature", BindAwayFromFeature, AwayFromFeatureShortfall},
    {"clear_of_feature", BindClearOfFeature, ClearOfFeatureShortfall},
    {"close_to_feature", BindCloseToFeature, CloseToFeatureShortfall},
    {"faces_feature", BindFacesFeature<Look::kOwn>, FacesFeatureShortfall<Look::kOwn>},
    {"under_window", BindUnderWindow, nullptr, "its place under the nearest window"},
    {"user_faces_feature", BindFacesFeature<Look::kOfUser>, FacesFeatureShortfall<Look::kOfUser>},
};

}  // namespace

std::span<const ConstraintCode> FeatureCode() { return kFeatureCode; }

}  // namespace flair::optimizer
