// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/text_format/scene_text.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <sstream>

#include "room/geometry/pose.h"
#include "worker_runtime/status/status_macros.h"

namespace flair {
namespace {

using Words = std::vector<std::string>;

std::vector<std::string> Split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

// Exactly `count` numbers with `separator` between them.
std::optional<std::vector<double>> Numbers(const std::string& text, char separator, size_t count) {
  std::vector<double> numbers;
  for (const std::string& part : Split(text, separator)) {
    double number = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
    if (error != std::errc() || end != part.data() + part.size()) return std::nullopt;
    numbers.push_back(number);
  }
  if (numbers.size() != count) return std::nullopt;
  return numbers;
}

// Reads the items of one text into a SceneText. Each Read function returns false when the item is not well formed.
class Reader {
 public:
  bool Read(const Words& words) {
    if (words.size() == 2 && words[1] == "room") return ReadRectangle(words[0]);
    if (words[0] == "room") return ReadPolygon(words);
    if (words[0] == "door" || words[0] == "window") return ReadOpening(words);
    if (words[0] == "socket") return ReadSocket(words);
    if (words[0] == "zone") return ReadZone(words);
    return ReadObject(words);
  }
  SceneText Take() { return std::move(result_); }

 private:
  Room& room() { return result_.scene.room; }

  bool ReadRectangle(const std::string& size) {
    const auto numbers = Numbers(size, 'x', 2);
    if (!numbers.has_value() || (*numbers)[0] <= 0 || (*numbers)[1] <= 0) return false;
    room() = RectangularRoom((*numbers)[0], (*numbers)[1]);
    return true;
  }

  bool ReadPolygon(const Words& words) {
    for (size_t i = 1; i < words.size(); ++i) {
      const auto point = Numbers(words[i], ',', 2);
      if (!point.has_value()) return false;
      room().floor.vertices.push_back({(*point)[0], (*point)[1]});
    }
    room().walls = WallsOf(room().floor);
    return IsSimple(room().floor) && SignedArea(room().floor.vertices) > 0;
  }

  bool ReadOpening(const Words& words) {
    if (words.size() < 4) return false;
    Opening opening;
    const bool door = words[0] == "door";
    opening.kind = door ? OpeningKind::kDoor : OpeningKind::kWindow;
    opening.id = fmt::format("{}_{}", words[0], room().openings.size() + 1);
    opening.wall = room().WallIndex(words[1]);
    const auto offset = Numbers(words[2], ' ', 1);
    const auto width = Numbers(words[3], ' ', 1);
    if (opening.wall < 0 || !offset.has_value() || !width.has_value()) return false;
    opening.offset_m = (*offset)[0];
    opening.width_m = (*width)[0];
    opening.sill_height_m = door ? 0 : 0.9;
    opening.head_height_m = door ? 2 : 2.1;
    if (door) opening.leaf.emplace();
    for (size_t i = 4; i < words.size(); ++i) {
      if (words[i] == "hinge_end" && door) {
        opening.leaf->hinge = HingeSide::kEnd;
      } else if (words[i] == "outward" && door) {
        opening.leaf->swing = DoorSwing::kOutward;
      } else if (words[i] == "sliding" && door) {
        opening.leaf->swing = DoorSwing::kSliding;
      } else if (words[i] == "open" && door) {
        opening.leaf->swing = DoorSwing::kNone;
      } else if (words[i] == "sill") {
        if (!ReadNumber(words, ++i, opening.sill_height_m)) return false;
      } else if (words[i] == "head") {
        if (!ReadNumber(words, ++i, opening.head_height_m)) return false;
      } else {
        return false;
      }
    }
    room().openings.push_back(opening);
    return true;
  }

  bool ReadSocket(const Words& words) {
    if (words.size() < 3) return false;
    Socket socket{fmt::format("socket_{}", room().sockets.size() + 1), room().WallIndex(words[1]), 0, 0.3};
    if (socket.wall < 0 || !ReadNumber(words, 2, socket.offset_m)) return false;
    if (words.size() == 5 && words[3] == "height" && !ReadNumber(words, 4, socket.height_m)) return false;
    room().sockets.push_back(socket);
    return words.size() == 3 || words.size() == 5;
  }

  bool ReadZone(const Words& words) {
    if (words.size() != 2 && !(words.size() == 4 && words[2] == "at")) return false;
    Vec2<double> center = BoundsOf(room().floor).Center();
    if (words.size() == 4) {
      const auto point = Numbers(words[3], ',', 2);
      if (!point.has_value()) return false;
      center = {(*point)[0], (*point)[1]};
    }
    result_.scene.zones.push_back({words[1], words[1]});
    result_.zone_centers.push_back(center);
    return true;
  }

  bool ReadObject(const Words& words) {
    if (words.size() < 4 || words[2] != "at") return false;
    const auto size = Numbers(words[1], 'x', 2);
    const auto pose = Numbers(words[3], ',', 3);
    if (!size.has_value() || !pose.has_value() || result_.scene.IndexOf(words[0]) >= 0) return false;
    Object object;
    object.id = object.name = words[0];
    object.footprint = {(*size)[0], (*size)[1]};
    for (size_t i = 4; i < words.size(); ++i) {
      if (!ReadWord(words, i, object)) return false;
    }
    result_.scene.objects.push_back(object);
    result_.layout.push_back({(*pose)[0], (*pose)[1], (*pose)[2] * kPi / 180});
    return true;
  }

  bool ReadWord(const Words& words, size_t& i, Object& object) {
    const std::string& word = words[i];
    if (word == "wall") return object.kind = ObjectKind::kWall, true;
    if (word == "ceiling") return object.kind = ObjectKind::kCeiling, true;
    if (word == "surface") return object.kind = ObjectKind::kSurface, true;
    if (word == "rug") return object.walk_over = true;
    if (word == "round") return object.round = true;
    if (word == "seat") return object.seat = true;
    if (word == "sat_at") return object.sat_at = true;
    if (word == "primary") return object.role = ObjectRole::kPrimary, true;
    if (word == "tertiary") return object.role = ObjectRole::kTertiary, true;
    if (word == "height") return ReadNumber(words, ++i, object.height_m);
    if (word == "rim") return ReadNumber(words, ++i, object.rim_sides_m) && ReadNumber(words, ++i, object.rim_ends_m);
    if (word == "elevation") return ReadNumber(words, ++i, object.elevation_m);
    if (word == "zone" && i + 1 < words.size()) {
      object.zone = result_.scene.ZoneIndexOf(words[++i]);
      return object.zone >= 0;
    }
    if (word == "on" && i + 1 < words.size()) {
      object.host = result_.scene.IndexOf(words[++i]);
      return object.host >= 0;
    }
    return false;
  }

  static bool ReadNumber(const Words& words, size_t i, double& number) {
    if (i >= words.size()) return false;
    const auto numbers = Numbers(words[i], ' ', 1);
    if (!numbers.has_value()) return false;
    number = (*numbers)[0];
    return true;
  }

  SceneText result_;
};

}  // namespace

absl::StatusOr<SceneText> ParseScene(std::string_view text) {
  Reader reader;
  bool first = true;
  for (const std::string& item : Split(std::string(text), ';')) {
    std::istringstream stream(item);
    Words words;
    for (std::string word; stream >> word;) words.push_back(word);
    if (words.empty()) continue;
    const bool is_room = words[0] == "room" || (words.size() == 2 && words[1] == "room");
    if (is_room != first || !reader.Read(words)) {
      return InvalidArgument("scene text: cannot read \"{}\"", item);
    }
    first = false;
  }
  if (first) return absl::InvalidArgumentError("scene text: begin with a room such as \"4x3 room\"");
  return reader.Take();
}

}  // namespace flair
