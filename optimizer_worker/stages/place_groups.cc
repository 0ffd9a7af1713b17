// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/place_groups.h"

#include <algorithm>
#include <cmath>

#include "fmt/format.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/constraints/whole_room.h"
#include "optimizer_worker/solver/candidates.h"
#include "optimizer_worker/solver/hard_cost.h"
#include "optimizer_worker/stages/floor_stages.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

constexpr CandidateDensity kOfGroups{.wall_samples = 3, .floor_samples = 20, .partner_samples = 1};

class GroupPlacer {
 public:
  GroupPlacer(const SolveInput& input, const SearchInput& search_input, LayoutSearch& search)
      : input_(input),
        search_input_(search_input),
        search_(search),
        hard_(input.scene, input.keep_out, search.problem()) {}

  void Place(const Group& group, double noise, Random& random) {
    if (group.objects.size() == 1 || group.arrangements.empty() || search_input_.Stopped()) {
      search_.Construct(group.objects, noise, random);
      return;
    }
    Context(group);
    const double together = Together(group, noise, random);
    const std::vector<Pose<double>> best = best_;
    search_.Construct(group.objects, noise, random);
    Layout layout = search_.layout();
    if (CostOf(group, layout) <= together) return;
    for (size_t k = 0; k < best.size(); ++k) layout[group.objects[k]] = best[k];
    search_.set_layout(layout);
  }

 private:
  double CostOf(const Group& group, const Layout& layout) {
    std::vector<Pose<double>> poses;
    for (int object : group.objects) poses.push_back(layout[object]);
    search_.problem().Hold(group.objects, layout, false);
    return search_.problem().AroundHeld(poses, HUGE_VAL);
  }

  // What stands, and what of it the group's objects are named with.
  void Context(const Group& group) {
    placed_.clear();
    partners_.clear();
    for (int i = 0; i < search_.problem().object_count(); ++i) {
      if (search_.problem().placed(i)) placed_.push_back(i);
    }
    for (int object : group.objects) {
      for (int partner : input_.partners[object]) {
        if (search_.problem().placed(partner)) partners_.push_back(partner);
      }
    }
    std::sort(partners_.begin(), partners_.end());
    partners_.erase(std::unique(partners_.begin(), partners_.end()), partners_.end());
  }

  // The least cost of the group as one piece, its poses in best_.
  double Together(const Group& group, double noise, Random& random) {
    Problem& problem = search_.problem();
    hard_.Prepare(group.objects, problem, search_.layout());
    for (int object : group.objects) problem.SetPlaced(object, true);
    problem.Hold(group.objects, search_.layout(), true);
    double least = HUGE_VAL;
    best_.clear();
    for (const Arrangement& arrangement : group.arrangements) {
      Propose(group, arrangement, random);
      for (const Pose<double>& candidate : candidates_) {
        PoseGroup(arrangement, candidate, poses_);
        double cost = noise > 0 ? noise * random.Uniform() : 0.0;
        cost += hard_.At(poses_, least - cost);
        if (cost >= least) continue;
        cost += problem.AroundHeld(poses_, least - cost);
        if (cost >= least) continue;
        least = cost;
        best_ = poses_;
      }
    }
    for (int object : group.objects) problem.SetPlaced(object, false);
    return least;
  }

  // Poses of the first piece: its own, and those that bring the box round the group to walls and partners.
  void Propose(const Group& group, const Arrangement& arrangement, Random& random) {
    candidates_.clear();
    CandidateContext context{input_.scene, search_.layout(), placed_, partners_, search_input_.zone_centers};
    ProposeCandidates(context, group.objects[0], kOfGroups, random, candidates_);
    const BoundingBox box = BoxOf(input_.scene, group, arrangement);
    const Footprint footprint{box.width_m(), box.height_m()};
    context.box = &footprint;
    const size_t own = candidates_.size();
    ProposeCandidates(context, group.objects[0], kOfGroups, random, candidates_);
    const Vec2<double> center = box.Center();
    for (size_t i = own; i < candidates_.size(); ++i) {
      const Vec2<double> p = FrameOf(candidates_[i]).ToRoom(-center.x, -center.y);
      candidates_[i].x_m = p.x;
      candidates_[i].y_m = p.y;
    }
  }

  const SolveInput& input_;
  const SearchInput& search_input_;
  LayoutSearch& search_;
  HardCost hard_;
  std::vector<int> placed_, partners_;
  std::vector<Pose<double>> candidates_, poses_, best_;
};

constexpr size_t kMostArrangements = 6;
constexpr double kArrangeNoise = 0.3;
// Arrangements nearer than this are the same.
constexpr double kSamePlace_m = 0.02;
constexpr CandidateDensity kBesideOnly{.wall_samples = 0, .floor_samples = 0, .partner_samples = 0};
constexpr double kKeptApart_m = 5e-8, kNear_m = 0.6;
constexpr int kMostProjections = 300;

// Which sides of the first piece are at a wall.
struct Setting {
  bool back, left, right;
};
constexpr Setting kSettings[] = {{false, false, false}, {true, false, false}, {false, true, false},
                                 {false, false, true},  {true, true, false},  {true, false, true}};

// Two pieces side to side.
struct Joint {
  int from, to;
  Side from_side, to_side;
  double gap_m;

  Joint Reversed() const { return {to, from, to_side, from_side, gap_m}; }
};

class GroupArranger {
 public:
  GroupArranger(const SolveInput& input, const Group& group) : input_(input), group_(group), scene_(input.scene) {
    for (int object : group.objects) reach_m_ += 2 * CircumscribedRadius(scene_.objects[object].footprint);
  }

  std::vector<Arrangement> All() {
    for (const Setting& setting : kSettings) {
      Stand(setting);
      for (uint64_t attempt = 0; attempt < (setting.back || setting.left || setting.right ? 1u : 2u); ++attempt) {
        Keep(Arranged(attempt));
      }
    }
    return std::move(found_);
  }

 private:
  // The room of a setting, with the first piece at heading 0.
  void Stand(const Setting& setting) {
    const Footprint& first = scene_.objects[group_.objects[0]].footprint;
    const double left = first.width_m / 2 + (setting.left ? 0 : reach_m_);
    const double right = first.width_m / 2 + (setting.right ? 0 : reach_m_);
    const double back = first.depth_m / 2 + (setting.back ? 0 : reach_m_);
    scene_.room = RectangularRoom(left + right, back + first.depth_m / 2 + reach_m_);
    start_ = {left, back, 0};
    const bool free = !setting.back && !setting.left && !setting.right;
    terms_.clear();
    joints_.clear();
    const std::vector<Vec2<double>> centers(scene_.zones.size(), Vec2<double>{kEmptyZone_m, kEmptyZone_m});
    for (int e : group_.edges) {
      v1::ConstraintEdge edge = input_.graph.edges(e);
      std::vector<int> named = NamedObjects(edge, scene_);
      // Walls here have other names than those of the room.
      auto& arguments = *edge.mutable_arguments();
      arguments.erase(std::remove_if(arguments.begin(), arguments.end(),
                                     [](const v1::Argument& argument) { return argument.name() == "wall"; }),
                      arguments.end());
      // What a lone piece wants of the room is for later.
      if (free && named.size() < 2) continue;
      AddJoints(edge, named, setting);
      AddCall(edge, named, centers);
    }
    for (size_t k = 1; k < group_.objects.size(); ++k) {
      const int object = group_.objects[k];
      AddOwn(InBounds(scene_, object), input_.settings.lambdas.in_bounds, true, kInBoundsTerm);
      AddOwn(Aligned(scene_, object), 1, false, kAlignedTerm);
      for (size_t i = 0; i < k; ++i) {
        AddOwn(NoOverlapPair(scene_, group_.objects[i], object), input_.settings.lambdas.no_overlap, true,
               kNoOverlapTerm);
      }
    }
  }
  // Neighbours of a row, and pieces alike of which sides are to touch, have their places from each other.
  void AddJoints(const v1::ConstraintEdge& edge, const std::vector<int>& named, const Setting& setting) {
    const auto argument = [&](const char* name) {
      const auto found = std::ranges::find(edge.arguments(), name, &v1::Argument::name);
      return found == edge.arguments().end() ? v1::ArgumentValue() : found->value();
    };
    if (edge.type() == "row") {
      for (size_t k = 0; k + 1 < named.size(); ++k) {
        const Side on = setting.right ? Side::kLeft : Side::kRight, other = setting.right ? Side::kRight : Side::kLeft;
        joints_.push_back({named[k], named[k + 1], on, other, argument("gap_m").number()});
      }
      return;
    }
    const std::optional<Side> side = SideFromName(argument("object_side").text());
    const std::optional<Side> target_side = SideFromName(argument("target_side").text());
    if (edge.type() != "next_to" || !side || !target_side) return;
    const int object = scene_.IndexOf(argument("object").text()), target = scene_.IndexOf(argument("target").text());
    const Footprint &one = scene_.objects[object].footprint, &other = scene_.objects[target].footprint;
    if (one.width_m == other.width_m && one.depth_m == other.depth_m)
      joints_.push_back({target, object, *target_side, *side, 0});
  }
  // Places those that have their places from the first, and says who is left.
  std::vector<int> PlaceJoined(Problem& problem, Layout& layout) const {
    std::vector<int> rest(group_.objects.begin() + 1, group_.objects.end());
    const auto is_open = [&](int object) { return std::ranges::find(rest, object) != rest.end(); };
    for (bool more = true; more;) {
      more = false;
      for (const Joint& joint : joints_) {
        if (is_open(joint.from) == is_open(joint.to)) continue;
        const Joint way = is_open(joint.to) ? joint : joint.Reversed();
        layout[way.to] = Joined(layout[way.from], way);
        problem.SetPlaced(way.to, true);
        std::erase(rest, way.to);
        more = true;
      }
    }
    return rest;
  }
  Pose<double> Joined(const Pose<double>& from, const Joint& joint) const {
    const Footprint &one = scene_.objects[joint.from].footprint, &other = scene_.objects[joint.to].footprint;
    const Vec2<double> n = LocalNormal(joint.from_side), m = LocalNormal(joint.to_side);
    const double out_m =
        (ExtentBehind(one, joint.from_side) + ExtentBehind(other, joint.to_side)) / 2 + joint.gap_m + kKeptApart_m;
    // Side by side the backs are in line.
    const double ahead_m = n.x != 0 && m.x != 0 ? (other.depth_m - one.depth_m) / 2 : 0;
    const Vec2<double> p = FrameOf(from).ToRoom(out_m * n.x, out_m * n.y + ahead_m);
    const double turn_rad = std::atan2(n.y, n.x) + kPi - std::atan2(m.y, m.x);
    return {p.x, p.y, WrapHeading(from.theta_rad + turn_rad)};
  }
  void AddCall(const v1::ConstraintEdge& edge, std::vector<int> named, std::span<const Vec2<double>> centers) {
    absl::StatusOr<std::unique_ptr<Cost>> cost = Bind(edge, {scene_, centers, &input_.linked});
    if (cost.ok()) Add(*std::move(cost), std::move(named), edge.weight() > 0 ? edge.weight() : 1, false, edge.type());
  }
  void AddOwn(std::unique_ptr<Cost> cost, double weight, bool hard, const char* name) {
    if (cost == nullptr) return;
    std::vector<int> reads(cost->objects().begin(), cost->objects().end());
    Add(std::move(cost), std::move(reads), hard ? weight * kHardFactor : weight, hard, name);
  }
  void Add(std::unique_ptr<Cost> cost, std::vector<int> required, double weight, bool hard, std::string_view name) {
    Term& term = terms_.emplace_back();
    term.cost = std::move(cost);
    term.weight = weight;
    term.required = std::move(required);
    term.hard = hard;
    term.robust = !hard;
    term.name = name;
  }

  // Empty when they do not fit.
  Arrangement Arranged(uint64_t attempt) {
    const int count = static_cast<int>(scene_.objects.size());
    std::vector<int> active(terms_.size());
    for (size_t t = 0; t < active.size(); ++t) active[t] = static_cast<int>(t);
    Problem problem(terms_, std::move(active), count);
    Layout layout(static_cast<size_t>(count));
    problem.SetPlaced(group_.objects[0], true);
    layout[group_.objects[0]] = start_;
    const std::vector<int> others = PlaceJoined(problem, layout);
    const KeepOut keep_out(scene_.room);
    const SearchInput search_input{scene_, input_.partners, {}, input_.solver, keep_out, nullptr, {}, nullptr};
    LayoutSearch search(search_input, std::move(problem), std::move(layout));
    const std::vector<int> members(group_.objects.begin() + 1, group_.objects.end());
    Random random(CombineSeeds({input_.settings.seed, static_cast<uint64_t>(group_.objects[0]), attempt}));
    search.Construct(others, attempt == 0 ? 0.0 : kArrangeNoise, random);
    search.Sweep(members, 2, kBesideOnly, random);
    search.Descend(members, {.max_evaluations = 60, .relative_tolerance = 1e-6, .absolute_tolerance = 1e-7});
    layout = search.layout();
    SnapHeadings(scene_, members, layout);
    const int first[] = {group_.objects[0]};
    std::vector<double> x;
    for (int object : members) x.insert(x.end(), {layout[object].x_m, layout[object].y_m});
    ProjectOntoRows(SeparationRows(scene_, keep_out, members, first, layout, kNear_m, kKeptApart_m), x,
                    kMostProjections);
    for (size_t k = 0; k < members.size(); ++k) {
      layout[members[k]].x_m = x[2 * k];
      layout[members[k]].y_m = x[2 * k + 1];
    }
    if (!FindViolations(scene_, keep_out, group_.objects, layout, kTouching_m).empty()) return {};
    Arrangement arrangement;
    for (int object : group_.objects) {
      arrangement.push_back(
          {layout[object].x_m - start_.x_m, layout[object].y_m - start_.y_m, layout[object].theta_rad});
    }
    return arrangement;
  }

  void Keep(Arrangement arrangement) {
    if (arrangement.empty() || found_.size() >= kMostArrangements) return;
    const auto same = [&](const Arrangement& other) {
      for (size_t k = 0; k < arrangement.size(); ++k) {
        if (Distance(Center(arrangement[k]), Center(other[k])) > kSamePlace_m ||
            AngleBetween(arrangement[k].theta_rad, other[k].theta_rad) > kSamePlace_m) {
          return false;
        }
      }
      return true;
    };
    if (std::none_of(found_.begin(), found_.end(), same)) found_.push_back(std::move(arrangement));
  }

  const SolveInput& input_;
  const Group& group_;
  Scene scene_;
  double reach_m_ = 0.5;
  Pose<double> start_;
  std::vector<Term> terms_;
  std::vector<Joint> joints_;
  std::vector<Arrangement> found_;
};

}  // namespace

void PlaceGroups(const SolveInput& input, const SearchInput& search_input, std::span<const Group> groups, double noise,
                 Random& random, LayoutSearch& search) {
  GroupPlacer placer(input, search_input, search);
  for (const Group& group : groups) placer.Place(group, noise, random);
}

std::vector<Arrangement> ArrangeGroup(const SolveInput& input, const Group& group) {
  return GroupArranger(input, group).All();
}

std::string CallText(const SolveInput& input, const Group& group, int e) {
  const v1::ConstraintEdge& edge = input.graph.edges(e);
  std::string text = fmt::format("{} {}", edge.type(), edge.weight());
  const auto name = [&](const std::string& id) {
    const auto at = std::find(group.objects.begin(), group.objects.end(), input.scene.IndexOf(id));
    return at == group.objects.end() ? id : fmt::format("#{}", at - group.objects.begin());
  };
  for (const v1::Argument& argument : edge.arguments()) {
    text += fmt::format(" {}=", argument.name());
    const v1::ArgumentValue& value = argument.value();
    if (value.has_text()) {
      text += name(value.text());
    } else if (value.has_texts()) {
      for (const std::string& item : value.texts().items()) text += name(item) + ",";
    } else {
      text += value.ShortDebugString();
    }
  }
  return text + ";";
}

}  // namespace flair::optimizer
