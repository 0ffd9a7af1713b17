// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "cli/explain/layout_note.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "optimizer_worker/constraints/shortfall.h"
#include "room/geometry/gap.h"
#include "room/geometry/pose.h"

namespace flair::cli {
namespace {

// Nearer than this a side touches; turned less than this it is parallel.
constexpr double kTouch_m = 0.06;
constexpr double kParallel_rad = 0.1;
// Farther things are no neighbours worth a word.
constexpr double kNeighbour_m = 1.5;
// A chair at its desk.
constexpr double kDrawnUp_m = 0.25;

struct WallContact {
  Side side = Side::kBack;
  const Wall* wall = nullptr;
};

class Place {
 public:
  Place(const Scene& scene, const PartialLayout& where, int object)
      : scene_(scene),
        where_(where),
        index_(object),
        object_(scene.objects[static_cast<size_t>(object)]),
        frame_(FrameOf(where.layout[static_cast<size_t>(object)])) {}

  std::string InWords() const {
    switch (object_.kind) {
      case ObjectKind::kSurface:
        return OnTop();
      case ObjectKind::kWall:
        return OnWall();
      case ObjectKind::kCeiling:
        return UnderCeiling();
      case ObjectKind::kFloor:
        break;
    }
    return object_.walk_over ? Lying() : OnFloor();
  }

 private:
  std::string Name(int object) const { return NameForPeople(scene_, object); }
  const Object& At(int object) const { return scene_.objects[static_cast<size_t>(object)]; }
  bool IsPlaced(int object) const { return where_.placed[static_cast<size_t>(object)]; }
  Frame<double> FrameAt(int object) const { return FrameOf(where_.layout[static_cast<size_t>(object)]); }
  Box<double> BoxAt(int object) const { return {At(object).footprint, FrameAt(object)}; }
  double GapTo(int other) const { return Gap<double>(BoxAt(index_), BoxAt(other)); }
  bool StandsSolid(int object) const { return object != index_ && IsPlaced(object) && IsSolid(At(object)); }

  // Sides that lie on a wall: back first.
  std::vector<WallContact> Contacts() const {
    std::vector<WallContact> contacts;
    for (const Side side : {Side::kBack, Side::kLeft, Side::kRight, Side::kFront}) {
      const Vec2<double> middle = optimizer::MiddleOf(object_.footprint, frame_, side);
      for (const Wall& wall : scene_.room.walls) {
        const double turn = std::acos(std::clamp(1 - optimizer::TurnToWall(frame_, side, wall), -1.0, 1.0));
        const bool beside = wall.Offset(middle) >= 0 && wall.Offset(middle) <= wall.length_m;
        if (beside && std::abs(wall.Height(middle)) < kTouch_m && turn < kParallel_rad)
          contacts.push_back({side, &wall});
      }
    }
    return contacts;
  }

  // "in the middle of it", "1.20 m from its west end".
  std::string Along(const Wall& wall) const {
    const double middle_m = wall.Offset(frame_.center);
    const double half_m = HalfAlong(wall);
    if (std::abs(middle_m - wall.length_m / 2) < 0.05) return "in its middle";
    const bool at_start = middle_m < wall.length_m / 2;
    const double free_m = at_start ? middle_m - half_m : wall.length_m - middle_m - half_m;
    return fmt::format("{:.2f} m from its {} end", std::max(0.0, free_m),
                       Compass(at_start ? -wall.Along() : wall.Along()));
  }

  double HalfAlong(const Wall& wall) const {
    return (object_.footprint.width_m * std::abs(Dot(frame_.right, wall.Along())) +
            object_.footprint.depth_m * std::abs(Dot(frame_.front, wall.Along()))) /
           2;
  }

  // The window that it stands before, when at least a third of either is before the other.
  const Opening* WindowBehind(const Wall& wall) const {
    const double middle_m = wall.Offset(frame_.center), half_m = HalfAlong(wall);
    for (const Opening& opening : scene_.room.openings) {
      if (opening.kind != OpeningKind::kWindow || &scene_.room.walls[static_cast<size_t>(opening.wall)] != &wall)
        continue;
      const double shared_m = std::min(middle_m + half_m, opening.offset_m + opening.width_m) -
                              std::max(middle_m - half_m, opening.offset_m);
      if (shared_m > std::min(2 * half_m, opening.width_m) / 3) return &opening;
    }
    return nullptr;
  }

  // As sentences about places under windows measure it: within the window's width, or the window within its own.
  bool IsWhollyAt(const Wall& wall, const Opening& window) const {
    const double off_m = wall.Offset(frame_.center) - window.offset_m - window.width_m / 2;
    return std::abs(off_m) <= std::abs(HalfAlong(wall) - window.width_m / 2) + kTouch_m;
  }

  // "the north-east corner"; of a room that is no rectangle the corner at those walls.
  std::string CornerOf(const Wall& a, const Wall& b) const {
    if (scene_.room.walls.size() != 4)
      return fmt::format("the corner of {} and {}", WallName(scene_.room, a), WallName(scene_.room, b));
    return fmt::format("the {} corner", Compass(-(a.inward_normal + b.inward_normal)));
  }

  std::string AtWalls(const std::vector<WallContact>& contacts) const {
    const WallContact& first = contacts.front();
    const bool flank = first.side == Side::kLeft || first.side == Side::kRight;
    const std::string side = fmt::format("{}{}", SideName(first.side), flank ? " side" : "");
    const auto second = std::ranges::find_if(contacts, [&](const WallContact& contact) {
      return std::abs(Dot(contact.wall->inward_normal, first.wall->inward_normal)) < 0.5;
    });
    std::string words;
    if (second != contacts.end()) {
      words = fmt::format("stands in {}, its {} to {}", CornerOf(*first.wall, *second->wall), side,
                          WallName(scene_.room, *first.wall));
    } else {
      words = fmt::format("stands with its {} to {}, {}", side, WallName(scene_.room, *first.wall), Along(*first.wall));
    }
    if (const Opening* const window = WindowBehind(*first.wall)) {
      const bool under = scene_.BottomOf(index_) + object_.height_m <= window->sill_height_m + 0.05;
      words += fmt::format(", {}{}", IsWhollyAt(*first.wall, *window) ? "" : "partly ",
                           under ? "under a window" : "in front of a window");
    }
    return words;
  }

  bool IsSeat() const {
    for (const char* word : {"chair", "stool", "bench", "seat"}) {
      if (object_.name.find(word) != std::string::npos) return true;
    }
    return false;
  }

  // For what stands free: at what it looks, or the wall it is nearest to.
  std::string OffWalls(int seen) const {
    if (seen >= 0 && GapTo(seen) < kDrawnUp_m) {
      return fmt::format("stands {} {}", IsSeat() ? "drawn up to" : "right in front of", Name(seen));
    }
    double least_m = std::numeric_limits<double>::infinity();
    const Wall* nearest = &scene_.room.walls.front();
    for (const Wall& wall : scene_.room.walls) {
      const double gap_m = Gap<double>(BoxAt(index_), ConvexPiece(Segment{wall.start, wall.end}));
      if (gap_m < least_m) least_m = gap_m, nearest = &wall;
    }
    return fmt::format("stands free in the room, {:.2f} m from {}, looking {}", std::max(0.0, least_m),
                       WallName(scene_.room, *nearest),
                       seen >= 0 ? fmt::format("at {}", Name(seen)) : Compass(frame_.front));
  }

  // What is straight before it within reach of a word; -1 for nothing.
  int Seen() const {
    double least_m = kNeighbour_m;
    int seen = -1;
    for (int other = 0; other < static_cast<int>(scene_.objects.size()); ++other) {
      if (!StandsSolid(other)) continue;
      const Vec2<double> p = frame_.ToObject(FrameAt(other).center);
      const double half_m = std::max(At(other).footprint.width_m, object_.footprint.width_m) / 2;
      if (p.y <= 0 || std::abs(p.x) > half_m || GapTo(other) >= least_m) continue;
      least_m = GapTo(other);
      seen = other;
    }
    return seen;
  }

  // Where another is, as the plan shows it: whose left a side is can be taken either way.
  std::string SideTo(int other) const {
    const Vec2<double> p = frame_.ToObject(FrameAt(other).center);
    const double x = p.x / (object_.footprint.width_m + At(other).footprint.width_m);
    const double y = p.y / (object_.footprint.depth_m + At(other).footprint.depth_m);
    if (std::abs(x) > std::abs(y)) return fmt::format("to its {}", Compass(x < 0 ? -frame_.right : frame_.right));
    return y < 0 ? "behind it" : "in front of it";
  }

  // What touches it, else what is next; but for what has been named already.
  std::string Neighbours(int named) const {
    std::vector<std::string> touching;
    double least_m = kNeighbour_m;
    int nearest = -1;
    for (int other = 0; other < static_cast<int>(scene_.objects.size()); ++other) {
      if (!StandsSolid(other) || other == named) continue;
      const double gap_m = GapTo(other);
      if (gap_m < kTouch_m && touching.size() < 5) touching.push_back(fmt::format("{} {}", Name(other), SideTo(other)));
      if (gap_m < least_m) least_m = gap_m, nearest = other;
    }
    if (!touching.empty()) return fmt::format(", with {}", Joined(touching));
    return nearest < 0 || named >= 0 ? "" : fmt::format("; {:.2f} m to {}", least_m, Name(nearest));
  }

  std::string OnFloor() const {
    const std::vector<WallContact> contacts = Contacts();
    if (!contacts.empty()) return AtWalls(contacts) + Neighbours(-1);
    const int seen = Seen();
    return OffWalls(seen) + Neighbours(seen);
  }

  // Of a rug: what stands on it.
  std::string Lying() const {
    std::vector<std::string> above;
    for (int other = 0; other < static_cast<int>(scene_.objects.size()); ++other) {
      if (StandsSolid(other) && GapTo(other) < -0.02) above.push_back(Name(other));
    }
    if (!above.empty()) return fmt::format("lies on the floor under {}", Joined(above));
    for (const WallContact& contact : Contacts())
      return fmt::format("lies at {}", WallName(scene_.room, *contact.wall));
    return "lies on the open floor";
  }

  int Carrier() const { return CarrierOf(scene_, index_, where_.layout, where_.placed); }

  std::string OnTop() const {
    const int carrier = Carrier();
    if (carrier < 0) return fmt::format("stands {:.2f} m above the floor", scene_.BottomOf(index_));
    const Vec2<double> p = FrameAt(carrier).ToObject(frame_.center);
    const Footprint& top = At(carrier).footprint;
    const char* const deep = p.y > top.depth_m / 6 ? "front" : p.y < -top.depth_m / 6 ? "back" : "";
    const char* const wide = p.x > top.width_m / 6 ? "right" : p.x < -top.width_m / 6 ? "left" : "";
    std::string part = fmt::format("{}{}{}", deep, *deep != 0 && *wide != 0 ? " " : "", wide);
    part = part.empty() ? "in the middle" : fmt::format("at the {}", part);
    return fmt::format("stands on {}, {} of its top, {:.2f} m up", Name(carrier), part, scene_.TopOf(carrier));
  }

  // The wall object's height, and what stands below it.
  std::string OnWall() const {
    const std::vector<WallContact> contacts = Contacts();
    std::string words = contacts.empty() ? "hangs free of the walls"
                                         : fmt::format("hangs on {}", WallName(scene_.room, *contacts.front().wall));
    std::vector<std::string> below;
    for (int other = 0; !contacts.empty() && other < static_cast<int>(scene_.objects.size()); ++other) {
      if (!StandsSolid(other) || GapTo(other) > 0.25) continue;
      const Wall& wall = *contacts.front().wall;
      const Vec2<double> p = frame_.ToObject(FrameAt(other).center);
      const double reach_m = Place(scene_, where_, other).HalfAlong(wall) + HalfAlong(wall);
      if (std::abs(p.x) < reach_m) below.push_back(Name(other));
    }
    if (!below.empty()) words += fmt::format(" above {}", Joined(below));
    return words + fmt::format(", {:.2f} m to {:.2f} m up", scene_.BottomOf(index_), scene_.TopOf(index_));
  }

  std::string UnderCeiling() const {
    const Vec2<double> middle = BoundsOf(scene_.room.floor).Center();
    std::string words = "hangs from the ceiling";
    if (Distance(middle, frame_.center) < 0.1) words += " in the middle of the room";
    const int below = Carrier();
    if (below >= 0) words += fmt::format(" above {}", Name(below));
    return words + fmt::format(", {:.2f} m up", scene_.BottomOf(index_));
  }

  const Scene& scene_;
  const PartialLayout& where_;
  const int index_;
  const Object& object_;
  const Frame<double> frame_;
};

}  // namespace

std::string Standing(const Scene& scene, const PartialLayout& where, int object) {
  return Place(scene, where, object).InWords();
}

std::string Compass(const Vec2<double>& direction) {
  static constexpr std::array<const char*, 8> kNames = {"east", "north-east", "north", "north-west",
                                                        "west", "south-west", "south", "south-east"};
  const double eighths = std::atan2(direction.y, direction.x) / (kPi / 4);
  return kNames[static_cast<size_t>((static_cast<int>(std::lround(eighths)) + 8) % 8)];
}

}  // namespace flair::cli
