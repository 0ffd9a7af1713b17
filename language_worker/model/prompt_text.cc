// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/prompt_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>

#include "language_worker/handbook/objects/fit_floor.h"
#include "llm/answers/prompt_library.h"

namespace flair::language {
namespace {

double Rounded(double value_m) { return std::round(value_m * 100) / 100; }

std::string OpeningText(const v1::Opening& opening) {
  std::string text = fmt::format("{} {} m wide", opening.id(), Rounded(opening.width_m()));
  if (opening.kind() == v1::OPENING_KIND_WINDOW) text += fmt::format(" from {} m up", Rounded(opening.sill_height_m()));
  return text;
}

std::string WallText(const v1::Room& room, int index) {
  const auto& vertices = room.floor().vertices();
  const v1::Point2 &a = vertices[index], &b = vertices[(index + 1) % vertices.size()];
  const std::string& name = room.walls(index).name();
  std::string text = fmt::format("{} wall {} m", name, Rounded(std::hypot(b.x_m() - a.x_m(), b.y_m() - a.y_m())));
  std::vector<std::string> things;
  for (const v1::Opening& opening : room.openings()) {
    if (opening.wall() == name) things.push_back(OpeningText(opening));
  }
  const auto sockets =
      std::ranges::count_if(room.sockets(), [&](const v1::Socket& socket) { return socket.wall() == name; });
  if (sockets == 1) things.push_back("a socket");
  if (sockets > 1) things.push_back(fmt::format("{} sockets", sockets));
  return things.empty() ? text : fmt::format("{}: {}", text, fmt::join(things, ", "));
}

// "dining_chair_3" without its number.
std::string BaseOf(const std::string& id) {
  const size_t digits = id.find_last_not_of("0123456789");
  if (digits == std::string::npos || digits + 1 == id.size() || digits == 0 || id[digits] != '_') return id;
  return id.substr(0, digits);
}

bool Alike(const v1::Object& a, const v1::Object& b) {
  return a.name() == b.name() && a.zone_id() == b.zone_id() && a.role() == b.role() && a.kind() == b.kind() &&
         a.width_m() == b.width_m() && a.depth_m() == b.depth_m();
}

// Whether an id can tell a name: ids have Latin letters alone.
bool IsInItsId(const std::string& name) {
  return std::ranges::any_of(name, [](unsigned char c) { return c < 0x80 && std::isalpha(c) != 0; });
}

std::string SizeText(const v1::Room& room) {
  const FloorExtent extent = ExtentOf(room);
  return fmt::format("{}, {} m x {} m ({} m2), {} m high", llm::QuoteData(room.room_type()), Rounded(extent.width_m),
                     Rounded(extent.depth_m), std::round(extent.area_m2 * 10) / 10, Rounded(room.height_m()));
}

bool IsIdCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

std::string Lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

}  // namespace

std::string ShortRoomText(const v1::Room& room) {
  const auto doors = std::ranges::count_if(
      room.openings(), [](const v1::Opening& opening) { return opening.kind() == v1::OPENING_KIND_DOOR; });
  const auto windows = room.openings_size() - doors;
  return fmt::format("{}, {} door{}, {} window{}", SizeText(room), doors, doors == 1 ? "" : "s", windows,
                     windows == 1 ? "" : "s");
}

std::string RoomText(const v1::Room& room) {
  std::string text = SizeText(room);
  for (int i = 0; i < room.walls_size(); ++i) text += "; " + WallText(room, i);
  return text;
}

std::string ZonesText(const v1::ZonePlan& plan) {
  std::string text;
  for (const v1::Zone& zone : plan.zones()) {
    text += fmt::format("{}- {}: {}", text.empty() ? "" : "\n", zone.id(), llm::QuoteData(zone.purpose()));
  }
  return text;
}

std::vector<ObjectGroup> GroupObjects(const v1::ObjectList& list, bool floor_only) {
  std::vector<ObjectGroup> groups;
  for (const v1::Object& object : list.objects()) {
    if (floor_only && object.role() == v1::OBJECT_ROLE_TERTIARY) continue;
    const auto same =
        std::ranges::find_if(groups, [&](const ObjectGroup& group) { return Alike(*group.objects.front(), object); });
    if (same != groups.end()) {
      same->objects.push_back(&object);
    } else {
      groups.push_back({object.id(), {&object}});
    }
  }
  std::set<std::string> taken;
  for (const v1::Object& object : list.objects()) taken.insert(object.id());
  for (ObjectGroup& group : groups) {
    if (group.objects.size() < 2) continue;
    // A second group of the same base (chairs of another zone) keeps its first member's id in its name.
    group.name = BaseOf(group.objects.front()->id());
    if (!taken.insert(group.name).second) group.name = group.objects.front()->id() + "_and_like";
    taken.insert(group.name);
  }
  return groups;
}

std::string GroupsText(const std::vector<ObjectGroup>& groups) {
  std::string text;
  for (const ObjectGroup& group : groups) {
    const v1::Object& first = *group.objects.front();
    std::string names = first.id();
    if (group.objects.size() > 1) {
      names = fmt::format("{} to {}, together {}", first.id(), group.objects.back()->id(), group.name);
    }
    if (!IsInItsId(first.name())) names += " " + llm::QuoteData(first.name());
    text += fmt::format("{}- {}{} ({}): {} x {} x {} m", text.empty() ? "" : "\n", names,
                        first.role() == v1::OBJECT_ROLE_PRIMARY ? "*" : "",
                        first.zone_id().empty() ? "room" : first.zone_id(), Rounded(first.width_m()),
                        Rounded(first.depth_m()), Rounded(first.height_m()));
  }
  return text;
}

llm::Choices GroupChoices(const std::vector<ObjectGroup>& groups) {
  llm::Choices choices;
  for (const ObjectGroup& group : groups) {
    choices.names.push_back(group.name);
    if (group.objects.size() < 2) continue;
    for (const v1::Object* object : group.objects) choices.names.push_back(object->id());
  }
  // A name that several groups have means none of them.
  for (const ObjectGroup& group : groups) {
    const std::string& name = group.objects.front()->name();
    const auto count =
        std::ranges::count_if(groups, [&](const ObjectGroup& other) { return other.objects.front()->name() == name; });
    if (count == 1) choices.aliases[name] = group.name;
  }
  return choices;
}

std::vector<std::string> IdsOf(const std::string& name, const std::vector<ObjectGroup>& groups) {
  std::vector<std::string> ids;
  for (const ObjectGroup& group : groups) {
    for (const v1::Object* object : group.objects) {
      if (group.name == name || object->id() == name) ids.push_back(object->id());
    }
  }
  return ids;
}

std::string Ordinal(size_t number) {
  constexpr std::array<const char*, 10> kOrdinals = {"first", "second",  "third",  "fourth", "fifth",
                                                     "sixth", "seventh", "eighth", "ninth",  "tenth"};
  return number < kOrdinals.size() ? kOrdinals[number] : fmt::format("{}th", number + 1);
}

ObjectWords::ObjectWords(const v1::ObjectList& objects, const v1::Room& room) {
  std::map<std::string, size_t> count, number;
  for (const v1::Object& object : objects.objects()) ++count[object.name()];
  for (const v1::Object& object : objects.objects()) {
    const size_t at = number[object.name()]++;
    words_[object.id()] = count[object.name()] > 1 ? fmt::format("{} {}", Ordinal(at), object.name()) : object.name();
  }
  for (const ObjectGroup& group : GroupObjects(objects, /*floor_only=*/false)) {
    words_.emplace(group.name, group.objects.front()->name());
  }
  for (const v1::Opening& opening : room.openings()) {
    words_.emplace(opening.id(), opening.kind() == v1::OPENING_KIND_DOOR ? "door" : "window");
  }
  for (const v1::Socket& socket : room.sockets()) words_.emplace(socket.id(), "socket");
}

std::string ObjectWords::InWords(const std::string& sentence) const {
  std::string words;
  for (size_t i = 0; i < sentence.size();) {
    if (!IsIdCharacter(sentence[i])) {
      words += sentence[i++];
      continue;
    }
    size_t end = i;
    while (end < sentence.size() && IsIdCharacter(sentence[end])) ++end;
    const std::string_view token = std::string_view(sentence).substr(i, end - i);
    // Without "_" it is a word like any other.
    const auto found = token.find('_') == std::string_view::npos ? words_.end() : words_.find(Lower(token));
    words += found == words_.end() ? token : std::string_view(found->second);
    i = end;
  }
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words;
}

}  // namespace flair::language
