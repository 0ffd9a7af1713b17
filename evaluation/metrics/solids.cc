// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "evaluation/metrics/measures.h"
#include "room/geometry/gap.h"
#include "room/geometry/polygon.h"
#include "room/scene/room.h"

namespace flair::evaluation {
namespace {

constexpr double kTouch_m = 1e-4;
constexpr double kTouchUp_m = 0.01;
constexpr double kKneeSpace_m = 0.3, kLeastTop_m = 0.6, kMostTop_m = 1.2;
constexpr double kOffWall_m = 0.01, kOverEdge_m = 0.01;
constexpr double kHeadroom_m = 1.9;
// Of a lamp that hangs low this much may be beside the table below it.
constexpr double kBesideShare = 0.5;

struct Prism {
  int object;
  Box<double> box;
  std::array<Vec2<double>, 4> corners;
  double low_m, high_m;
  // What a surface piece stands on; -1.
  int carrier;
};

double SharedHeight(const Prism& a, double low_m, double high_m) {
  return std::min(a.high_m, high_m) - std::max(a.low_m, low_m);
}

template <typename A, typename B>
double Depth(const A& a, const B& b) {
  return -SeparatingAxis(a, b).gap_m;
}

class Measurer {
 public:
  explicit Measurer(const LayoutView& view) : view_(view), scene_(view.scene) {
    const std::vector<bool> placed = view.placed.empty() ? std::vector<bool>(scene_.objects.size(), true) : view.placed;
    for (size_t i = 0; i < scene_.objects.size(); ++i) {
      if (!placed[i]) continue;
      const Object& object = scene_.objects[i];
      const int index = static_cast<int>(i);
      const bool stands = object.kind == ObjectKind::kSurface;
      const int carrier = stands ? CarrierOf(scene_, index, view.layout, placed) : -1;
      const double low_m = UndersideOf(scene_, index, view.layout, placed);
      const Frame<double> frame = FrameOf(view.layout[i]);
      prisms_.push_back({index, Box<double>(object.footprint, frame), Corners(object.footprint, frame), low_m,
                         low_m + object.height_m, carrier});
    }
  }

  SolidMeasures Measure() {
    for (size_t i = 0; i < prisms_.size(); ++i) {
      for (size_t k = 0; k < i; ++k) ComparePair(prisms_[k], prisms_[i]);
    }
    for (const Opening& opening : scene_.room.openings) CompareWithOpening(opening);
    for (const Prism& prism : prisms_) {
      CheckInside(prism);
      CheckSupport(prism);
      CheckHeadroom(prism);
    }
    std::ranges::stable_sort(result_.findings, [](const auto& a, const auto& b) {
      return a.kind() != b.kind() ? a.kind() < b.kind() : a.amount() > b.amount();
    });
    return std::move(result_);
  }

 private:
  const Object& At(int object) const { return scene_.objects[static_cast<size_t>(object)]; }
  std::string Name(int object) const { return NameForPeople(scene_, object); }

  void Tell(v1::FindingKind kind, int object, const std::string& partner, double amount_m, std::string message) {
    v1::Finding& finding = result_.findings.emplace_back();
    finding.set_kind(kind);
    finding.set_object_id(At(object).id);
    finding.set_partner_id(partner);
    finding.set_amount(amount_m);
    finding.set_unit("m");
    finding.set_message(std::move(message));
  }

  bool IsCarried(const Prism& a, const Prism& b) const {
    return a.carrier == b.object || scene_.Carries(b.object, a.object) ||
           (a.carrier >= 0 && scene_.Carries(b.object, a.carrier));
  }

  bool CanMeet(const Prism& a, const Prism& b) const {
    const Object& first = At(a.object);
    const Object& second = At(b.object);
    if (first.walk_over || second.walk_over || IsCarried(a, b) || IsCarried(b, a)) return false;
    const bool on_one_top = a.carrier >= 0 && a.carrier == b.carrier;
    if (on_one_top && std::min(first.height_m, second.height_m) <= kFlat_m) return false;
    return SharedHeight(a, b.low_m, b.high_m) > kTouchUp_m;
  }

  // Whether `seat` reaches into `table` with its front alone, no further than knees do. A piece that nobody has classed
  // may be a seat, or a table.
  bool IsPushedUnder(const Prism& seat, const Prism& table) const {
    if (!IsSolid(At(seat.object)) || !IsSolid(At(table.object)) || At(table.object).seat) return false;
    if (!At(seat.object).seat && !At(seat.object).category.empty()) return false;
    if (!At(table.object).sat_at && !At(table.object).category.empty()) return false;
    if (table.high_m < kLeastTop_m || table.high_m > kMostTop_m) return false;
    const Footprint& whole = At(seat.object).footprint;
    Frame<double> rear = FrameOf(view_.layout[static_cast<size_t>(seat.object)]);
    const double kept_m = std::max(whole.depth_m - kKneeSpace_m, 0.1);
    rear.center = rear.ToRoom(0.0, (kept_m - whole.depth_m) / 2);
    return Depth(Box<double>({whole.width_m, kept_m}, rear), table.box) <= kTouch_m;
  }

  void ComparePair(const Prism& a, const Prism& b) {
    const double reach = CircumscribedRadius(At(a.object).footprint) + CircumscribedRadius(At(b.object).footprint);
    if (SquaredNorm(a.box.value_center() - b.box.value_center()) >= reach * reach || !CanMeet(a, b)) return;
    const double across_m = Depth(a.box, b.box);
    if (across_m <= kTouch_m || IsPushedUnder(a, b) || IsPushedUnder(b, a)) return;
    const double up_m = SharedHeight(a, b.low_m, b.high_m);
    // What is placed later is in the way of what is there.
    const bool a_is_later = IsSolid(At(b.object)) && !IsSolid(At(a.object));
    const int object = a_is_later ? a.object : b.object, other = a_is_later ? b.object : a.object;
    const double depth_m = AddOverlap(ConvexIntersectionArea(a.corners, b.corners), across_m, up_m);
    Tell(v1::FINDING_KIND_OVERLAP, object, At(other).id, depth_m,
         fmt::format("{} and {} overlap by {:.2f} m", Name(object), Name(other), depth_m));
  }

  double AddOverlap(double area_m2, double across_m, double up_m) {
    const double depth_m = std::min(across_m, up_m);
    result_.overlap_m3 += area_m2 * up_m;
    result_.deepest_m = std::max(result_.deepest_m, depth_m);
    return depth_m;
  }

  void CompareWithOpening(const Opening& opening) {
    std::vector<std::pair<ConvexPiece, Polygon>> swept;
    for (const Polygon& piece : ConvexSwingAreas(scene_.room, opening, kArcPieces)) {
      swept.emplace_back(ConvexPiece(piece), piece);
    }
    for (const Prism& prism : prisms_) {
      const double up_m = SharedHeight(prism, opening.sill_height_m, opening.head_height_m);
      if (up_m <= kTouchUp_m || At(prism.object).walk_over) continue;
      double across_m = 0, area_m2 = 0;
      for (const auto& [piece, polygon] : swept) {
        const double depth_m = Depth(prism.box, piece);
        if (depth_m <= kTouch_m) continue;
        across_m = std::max(across_m, depth_m);
        area_m2 += ConvexIntersectionArea(prism.corners, polygon.vertices);
      }
      if (across_m > 0) {
        const double depth_m = AddOverlap(area_m2, across_m, up_m);
        Tell(v1::FINDING_KIND_DOOR_LEAF, prism.object, opening.id, depth_m,
             fmt::format("{} hits {} when it opens, {:.2f} m deep", NameForPeople(scene_.room, opening),
                         Name(prism.object), depth_m));
      }
      const double covered_m = CoveredLength(view_, static_cast<size_t>(prism.object), opening);
      if (At(prism.object).kind != ObjectKind::kWall || covered_m <= kTouch_m) continue;
      const double depth_m = AddOverlap(covered_m * At(prism.object).footprint.depth_m, covered_m, up_m);
      Tell(v1::FINDING_KIND_COVERS_OPENING, prism.object, opening.id, depth_m,
           fmt::format("{} covers {:.2f} m of {}", Name(prism.object), covered_m, NameForPeople(scene_.room, opening)));
    }
  }

  void CheckInside(const Prism& prism) {
    const double height_m = At(prism.object).height_m;
    double out_m = 0;
    for (const Vec2<double>& corner : prism.corners) {
      out_m = std::max(out_m, -SignedDistance(scene_.room.floor, corner));
    }
    const double above_m = prism.high_m - scene_.room.height_m;
    if (out_m > kTouch_m) {
      const double area_m2 = At(prism.object).footprint.area_m2();
      const Polygon inside = ClipByConvex(scene_.room.floor, prism.corners);
      result_.outside_m3 += std::max(0.0, area_m2 - std::abs(SignedArea(inside.vertices))) * height_m;
    }
    if (above_m > kTouchUp_m) result_.outside_m3 += At(prism.object).footprint.area_m2() * std::min(above_m, height_m);
    if (out_m <= kTouch_m && above_m <= kTouchUp_m) return;
    const bool beside = out_m > kTouch_m && out_m >= above_m;
    const double amount_m = beside ? out_m : above_m;
    result_.deepest_m = std::max(result_.deepest_m, amount_m);
    Tell(v1::FINDING_KIND_OUTSIDE, prism.object, "", amount_m,
         fmt::format("{:.2f} m of {} is {}", amount_m, Name(prism.object),
                     beside ? "outside the room" : "above the ceiling"));
  }

  void Unsupported(const Prism& prism, int partner, double amount_m, std::string message) {
    ++result_.unsupported_count;
    Tell(v1::FINDING_KIND_UNSUPPORTED, prism.object, partner < 0 ? "" : At(partner).id, amount_m, std::move(message));
  }

  void CheckSupport(const Prism& prism) {
    const Object& object = At(prism.object);
    if (object.kind == ObjectKind::kWall) {
      const double off_m = OffWalls(prism);
      const std::string gap =
          fmt::format("between {} and the walls there is a gap of {:.2f} m", Name(prism.object), off_m);
      if (off_m > kOffWall_m) Unsupported(prism, -1, off_m, gap);
    } else if (object.kind == ObjectKind::kSurface && prism.carrier >= 0) {
      CheckOnTop(prism);
    } else if (object.kind != ObjectKind::kCeiling && prism.low_m > kTouchUp_m) {
      Unsupported(prism, -1, prism.low_m,
                  fmt::format("nothing carries {}, {:.2f} m above the floor", Name(prism.object), prism.low_m));
    } else if (object.kind == ObjectKind::kSurface) {
      Unsupported(prism, -1, 0, fmt::format("no piece carries {}, on the floor", Name(prism.object)));
    }
  }

  // How far the further back corner is from the nearest wall.
  double OffWalls(const Prism& prism) const {
    double least_m = 1e300;
    for (const Wall& wall : scene_.room.walls) {
      double off_m = 0;
      for (size_t corner : {size_t{0}, size_t{1}}) {
        off_m = std::max(off_m, DistanceTo(Segment{wall.start, wall.end}, prism.corners[corner]));
      }
      least_m = std::min(least_m, off_m);
    }
    return least_m;
  }

  void CheckOnTop(const Prism& prism) {
    const Object& top = At(prism.carrier);
    const Frame<double> frame = FrameOf(view_.layout[static_cast<size_t>(prism.carrier)]);
    const bool flat = At(prism.object).height_m <= kFlat_m;
    double over_m = 0;
    const auto consider = [&](const Vec2<double>& point) {
      const Vec2<double> p = frame.ToObject(point);
      over_m = std::max({over_m, std::abs(p.x) - top.footprint.width_m / 2, std::abs(p.y) - top.footprint.depth_m / 2});
    };
    if (flat) {
      consider(prism.box.value_center());
    } else {
      for (const Vec2<double>& corner : prism.corners) consider(corner);
    }
    if (over_m > kOverEdge_m) {
      Unsupported(
          prism, prism.carrier, over_m,
          fmt::format("{:.2f} m of {} is over the edge of {}", over_m, Name(prism.object), Name(prism.carrier)));
    } else if (const double sunk_m = SunkIn(prism, top, frame); sunk_m > kOverEdge_m) {
      Unsupported(
          prism, prism.carrier, sunk_m,
          fmt::format("{:.2f} m of {} is over the opening of {}", sunk_m, Name(prism.object), Name(prism.carrier)));
    }
  }

  // How far it stands over the opening in a top; 0 when it lies across from rim to rim, or is meant to be within.
  double SunkIn(const Prism& prism, const Object& top, const Frame<double>& frame) const {
    const std::optional<Footprint> opening = OpeningIn(top);
    if (!opening || At(prism.object).elevation_m < 0) return 0;
    double low_u = 1e300, high_u = -1e300, low_v = 1e300, high_v = -1e300;
    for (const Vec2<double>& corner : prism.corners) {
      const Vec2<double> p = frame.ToObject(corner);
      low_u = std::min(low_u, p.x), high_u = std::max(high_u, p.x);
      low_v = std::min(low_v, p.y), high_v = std::max(high_v, p.y);
    }
    const double half_u = opening->width_m / 2, half_v = opening->depth_m / 2;
    if ((low_u < -half_u && high_u > half_u) || (low_v < -half_v && high_v > half_v)) return 0;
    return std::max(0.0, Depth(prism.box, Box<double>(*opening, frame)));
  }

  void CheckHeadroom(const Prism& prism) {
    if (At(prism.object).kind != ObjectKind::kCeiling || prism.low_m >= kHeadroom_m - kTouchUp_m) return;
    double free_m2 = At(prism.object).footprint.area_m2();
    const double least_m2 = kBesideShare * free_m2;
    for (const Prism& below : prisms_) {
      if (IsSolid(At(below.object))) free_m2 -= ConvexIntersectionArea(prism.corners, below.corners);
    }
    if (free_m2 <= least_m2) return;
    Tell(v1::FINDING_KIND_HEADROOM, prism.object, "", kHeadroom_m - prism.low_m,
         fmt::format("under {} there is {:.2f} m above free floor; a person needs {:.2f} m", Name(prism.object),
                     prism.low_m, kHeadroom_m));
  }

  const LayoutView& view_;
  const Scene& scene_;
  std::vector<Prism> prisms_;
  SolidMeasures result_;
};

}  // namespace

SolidMeasures MeasureSolids(const LayoutView& view) { return Measurer(view).Measure(); }

}  // namespace flair::evaluation
