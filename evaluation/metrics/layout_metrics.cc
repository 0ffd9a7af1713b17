// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/metrics/layout_metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "evaluation/metrics/measures.h"
#include "evaluation/metrics/walk_grid.h"
#include "flair/v1/solved_layout.pb.h"
#include "room/conversion/conversion.h"
#include "room/geometry/gap.h"
#include "room/geometry/polygon.h"
#include "room/scene/room.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::evaluation {
namespace {

constexpr double kLeastArea_m2 = 1e-12;
constexpr double kHeightSlack_m = 1e-9;
// A picture may begin where a wardrobe or another picture ends, to the centimetre.
constexpr double kAboveSlack_m = 0.01;
// A wall object further than this from its wall hangs nowhere; it is then no matter of openings.
constexpr double kNearWall_m = 0.3;

std::array<Vec2<double>, 4> CornersOf(const LayoutView& view, size_t i) {
  return Corners(view.scene.objects[i].footprint, view.layout[i]);
}

bool HeightsOverlap(double low_a, double high_a, double low_b, double high_b, double slack_m = kHeightSlack_m) {
  return std::min(high_a, high_b) - std::max(low_a, low_b) > slack_m;
}

// A piece on the wall behind furniture that reaches up to it.
bool HangsBehind(const Scene& scene, int on_wall, int on_floor) {
  const Object& a = scene.objects[static_cast<size_t>(on_wall)];
  const Object& b = scene.objects[static_cast<size_t>(on_floor)];
  return a.kind == ObjectKind::kWall && IsSolid(b) && !scene.Carries(on_floor, on_wall) &&
         HeightsOverlap(scene.BottomOf(on_wall), scene.TopOf(on_wall), scene.BottomOf(on_floor), scene.TopOf(on_floor),
                        kAboveSlack_m);
}

bool CanCollide(const Scene& scene, size_t i, size_t k) {
  const Object& a = scene.objects[i];
  const Object& b = scene.objects[k];
  const int ia = static_cast<int>(i), ib = static_cast<int>(k);
  if (a.kind != b.kind) return HangsBehind(scene, ia, ib) || HangsBehind(scene, ib, ia);
  if (a.kind == ObjectKind::kFloor) return IsSolid(a) && IsSolid(b);
  if (scene.Carries(ia, ib) || scene.Carries(ib, ia)) return false;
  if (a.kind == ObjectKind::kSurface && std::min(a.height_m, b.height_m) <= kFlat_m) return false;
  return HeightsOverlap(scene.BottomOf(ia), scene.TopOf(ia), scene.BottomOf(ib), scene.TopOf(ib), kAboveSlack_m);
}

void AddPairs(const LayoutView& view, std::vector<Overlap>& overlaps) {
  const size_t count = view.scene.objects.size();
  for (size_t i = 0; i < count; ++i) {
    if (!view.Has(i)) continue;
    for (size_t k = i + 1; k < count; ++k) {
      if (!view.Has(k) || !CanCollide(view.scene, i, k)) continue;
      const double area = ConvexIntersectionArea(CornersOf(view, i), CornersOf(view, k));
      if (area > kLeastArea_m2) overlaps.push_back({view.scene.objects[i].id, view.scene.objects[k].id, area});
    }
  }
}

void AddDoorSwings(const LayoutView& view, std::vector<Overlap>& overlaps) {
  for (const Opening& door : view.scene.room.openings) {
    const std::vector<Polygon> swing = ConvexSwingAreas(view.scene.room, door, kArcPieces);
    for (size_t i = 0; i < view.scene.objects.size(); ++i) {
      if (!view.Has(i) || !IsSolid(view.scene.objects[i])) continue;
      double area = 0;
      for (const Polygon& piece : swing) area += ConvexIntersectionArea(CornersOf(view, i), piece.vertices);
      if (area > kLeastArea_m2) overlaps.push_back({view.scene.objects[i].id, door.id, area});
    }
  }
}

void AddCoveredOpenings(const LayoutView& view, std::vector<Overlap>& overlaps) {
  for (size_t i = 0; i < view.scene.objects.size(); ++i) {
    const Object& object = view.scene.objects[i];
    if (!view.Has(i) || object.kind != ObjectKind::kWall) continue;
    const int index = static_cast<int>(i);
    for (const Opening& opening : view.scene.room.openings) {
      if (!HeightsOverlap(view.scene.BottomOf(index), view.scene.TopOf(index), opening.sill_height_m,
                          opening.head_height_m)) {
        continue;
      }
      const double area = CoveredLength(view, i, opening) * object.footprint.depth_m;
      if (area > kLeastArea_m2) overlaps.push_back({object.id, opening.id, area});
    }
  }
}

bool IsUse(const v1::Sentence& sentence) { return sentence.use() || sentence.origin() == v1::SENTENCE_ORIGIN_IMPLIED; }

// The first call of a sentence that does not hold; null when all hold.
const v1::EdgeOutcome* Missed(const std::vector<const v1::EdgeOutcome*>& outcomes) {
  const auto missed = std::ranges::find_if(
      outcomes, [](const v1::EdgeOutcome* outcome) { return outcome->status() != v1::OUTCOME_STATUS_SATISFIED; });
  return missed == outcomes.end() ? nullptr : *missed;
}

v1::Finding NotMet(const v1::Sentence& sentence, const v1::EdgeOutcome* missed) {
  v1::Finding finding;
  finding.set_kind(v1::FINDING_KIND_USE_NOT_MET);
  if (sentence.subject_ids_size() > 0) finding.set_object_id(sentence.subject_ids(0));
  if (sentence.subject_ids_size() > 1) finding.set_partner_id(sentence.subject_ids(1));
  finding.set_sentence_id(sentence.id());
  const std::string why = missed == nullptr ? "no constraint could be made of it" : missed->reason();
  finding.set_message(why.empty() ? "\"" + sentence.text() + "\" does not hold" : why);
  if (missed != nullptr && missed->has_missed_by()) {
    finding.set_amount(missed->missed_by());
    finding.set_unit(missed->unit());
  }
  return finding;
}

}  // namespace

double CoveredLength(const LayoutView& view, size_t i, const Opening& opening) {
  if (view.scene.objects[i].at_window && opening.kind == OpeningKind::kWindow) return 0;
  const Wall& wall = view.scene.room.walls[static_cast<size_t>(opening.wall)];
  const double half_depth = view.scene.objects[i].footprint.depth_m / 2;
  if (std::abs(wall.Height(Center(view.layout[i]))) > half_depth + kNearWall_m) return 0;
  double low = 1e300, high = -1e300;
  for (const Vec2<double>& corner : CornersOf(view, i)) {
    low = std::min(low, wall.Offset(corner));
    high = std::max(high, wall.Offset(corner));
  }
  // A thing on the neighbouring wall is seen end on, next to the opening or beyond this wall's end.
  const Vec2<double> front = Front(view.layout[i]);
  if (Dot(front, wall.inward_normal) < 0.7) return 0;
  return std::max(0.0, std::min(high, opening.offset_m + opening.width_m) - std::max(low, opening.offset_m));
}

std::vector<Overlap> FindOverlaps(const LayoutView& view) {
  std::vector<Overlap> overlaps;
  AddPairs(view, overlaps);
  AddDoorSwings(view, overlaps);
  AddCoveredOpenings(view, overlaps);
  return overlaps;
}

std::vector<Outside> FindOutside(const LayoutView& view) {
  std::vector<Outside> outside;
  for (size_t i = 0; i < view.scene.objects.size(); ++i) {
    if (!view.Has(i)) continue;
    const Polygon inside = ClipByConvex(view.scene.room.floor, CornersOf(view, i));
    const double area = view.scene.objects[i].footprint.area_m2() - std::abs(SignedArea(inside.vertices));
    if (area > kLeastArea_m2) outside.push_back({view.scene.objects[i].id, area});
  }
  return outside;
}

double OobPercent(const LayoutView& view) {
  double area = 0;
  for (const Outside& outside : FindOutside(view)) area += outside.area_m2;
  return 100 * area / Area(view.scene.room.floor);
}

double OorPercent(const LayoutView& view) {
  double area = 0;
  for (const Overlap& overlap : FindOverlaps(view)) area += overlap.area_m2;
  return 100 * area / Area(view.scene.room.floor);
}

double DeepestOverlap_m(const LayoutView& view) {
  const Scene& scene = view.scene;
  double deepest = 0;
  std::vector<Box<double>> solids;
  const auto consider = [&deepest](const auto& a, const auto& b) {
    deepest = std::max(deepest, -SeparatingAxis(a, b).gap_m);
  };
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    if (!view.Has(i)) continue;
    const Box<double> box(scene.objects[i].footprint, FrameOf(view.layout[i]));
    for (int corner = 0; corner < 4; ++corner) {
      deepest = std::max(deepest, -SignedDistance(scene.room.floor, box.value(corner)));
    }
    if (!IsSolid(scene.objects[i])) continue;
    for (const Box<double>& other : solids) consider(box, other);
    solids.push_back(box);
  }
  for (const Opening& door : scene.room.openings) {
    for (const Polygon& piece : ConvexSwingAreas(scene.room, door, kArcPieces)) {
      const ConvexPiece swept(piece);
      for (const Box<double>& box : solids) consider(box, swept);
    }
  }
  return deepest;
}

v1::LayoutMetrics MeasureLayout(const LayoutView& view) {
  const Reach reach = MeasureReach(view);
  v1::LayoutMetrics metrics;
  metrics.set_oob_percent(OobPercent(view));
  metrics.set_oor_percent(OorPercent(view));
  metrics.set_reachable_floor_share(reach.floor_share);
  metrics.set_reachable_front_share(reach.front_share);
  metrics.set_pathway_cost_m3(PathwayCost_m3(view));
  metrics.set_deepest_overlap_m(DeepestOverlap_m(view));
  SolidMeasures solids = MeasureSolids(view);
  const double percent_per_m3 = 100 / (Area(view.scene.room.floor) * view.scene.room.height_m);
  metrics.set_oob_3d_percent(solids.outside_m3 * percent_per_m3);
  metrics.set_oor_3d_percent(solids.overlap_m3 * percent_per_m3);
  metrics.set_deepest_overlap_3d_m(solids.deepest_m);
  metrics.set_unsupported_count(solids.unsupported_count);
  for (v1::Finding& finding : solids.findings) *metrics.add_findings() = std::move(finding);
  return metrics;
}

absl::StatusOr<v1::LayoutMetrics> MeasureLayout(const v1::SolvedLayout& layout) {
  ASSIGN_OR_RETURN(const Scene scene, SceneFromProto(layout.graph()));
  ASSIGN_OR_RETURN(const PartialLayout partial, PosesFromPlacements(scene, layout.placements()));
  v1::LayoutMetrics metrics = MeasureLayout({scene, partial.layout, partial.placed});
  AddUses(layout.graph(), layout.placements(), layout.edge_outcomes(), metrics);
  return metrics;
}

void AddUses(const v1::LayoutGraph& graph, const google::protobuf::RepeatedPtrField<v1::Placement>& placements,
             const google::protobuf::RepeatedPtrField<v1::EdgeOutcome>& outcomes, v1::LayoutMetrics& metrics) {
  std::set<std::string_view> placed;
  for (const v1::Placement& placement : placements) placed.insert(placement.object_id());
  std::map<std::string_view, std::vector<const v1::EdgeOutcome*>> outcomes_of;
  for (int e = 0; e < std::min(graph.edges_size(), outcomes.size()); ++e) {
    outcomes_of[graph.edges(e).sentence_id()].push_back(&outcomes[e]);
  }
  int asked = 0, met = 0;
  const absl::StatusOr<Scene> scene = SceneFromProto(graph);
  const auto where =
      scene.ok() ? PosesFromPlacements(*scene, placements) : absl::StatusOr<PartialLayout>(scene.status());
  if (where.ok()) {
    UsesOfWays ways = FindUsesOfWays({*scene, where->layout, where->placed});
    asked = ways.asked;
    met = ways.met;
    const int count = static_cast<int>(ways.unmet.size());
    for (v1::Finding& finding : ways.unmet) *metrics.add_findings() = std::move(finding);
    const auto all = metrics.mutable_findings();
    std::rotate(all->pointer_begin(), all->pointer_end() - count, all->pointer_end());
  }
  for (const v1::Sentence& sentence : graph.constraint_list().sentences()) {
    const auto is_placed = [&](const std::string& id) { return placed.contains(id); };
    if (!IsUse(sentence) || !std::ranges::all_of(sentence.subject_ids(), is_placed)) continue;
    ++asked;
    const std::vector<const v1::EdgeOutcome*>& own = outcomes_of[sentence.id()];
    const v1::EdgeOutcome* const missed = Missed(own);
    if (!own.empty() && missed == nullptr) {
      ++met;
    } else {
      *metrics.add_findings() = NotMet(sentence, missed);
    }
  }
  metrics.set_use_count(asked);
  metrics.set_met_use_count(met);
}

}  // namespace flair::evaluation
