// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/styling/choose_style.h"
#include "language_worker/recorded/import_answers.h"

namespace flair::language {
namespace {

// Heights of what the handbook does not know.
constexpr double kFloorHeight_m = 0.8, kItemHeight_m = 0.25, kWallHeight_m = 0.5, kLampHeight_m = 0.5;
constexpr double kRugHeight_m = 0.01;

std::string NameFor(const v1::Object& object, int count) {
  std::string name = PlainName(object.name());
  if (count > 1 && name.ends_with("s") && !name.ends_with("ss")) {
    // "dining chairs", four times
    const std::vector<Word> words = ReadWords(name);
    if (!words.empty()) name = name.substr(0, words.back().begin) + words.back().key;
  }
  constexpr size_t kLongestName = 60;
  return name.size() <= kLongestName ? name : name.substr(0, kLongestName);
}

bool Alike(const v1::Object& a, const v1::Object& b) {
  return NameKey(a.name()) == NameKey(b.name()) && a.zone_id() == b.zone_id() && a.kind() == b.kind() &&
         a.width_m() == b.width_m() && a.depth_m() == b.depth_m();
}

const char* WordOf(v1::ObjectKind kind) {
  if (kind == v1::OBJECT_KIND_WALL) return "wall";
  if (kind == v1::OBJECT_KIND_CEILING) return "ceiling";
  return kind == v1::OBJECT_KIND_SURFACE ? "surface" : "floor";
}

double WallLength(const v1::Room& room, const std::string& wall) {
  const v1::Point2& far = room.floor().vertices(2);
  return wall == "south" || wall == "north" ? far.x_m() : far.y_m();
}

double Rounded(double value) { return std::round(value * 1e4) / 1e4; }

// Where along a wall, as answers count: from its west or south end.
double PositionOf(const v1::Room& room, const std::string& wall, double offset_m) {
  const double position = offset_m / WallLength(room, wall);
  return Rounded(std::clamp(wall == "north" || wall == "west" ? 1 - position : position, 0.0, 1.0));
}

// The wall, or the one that it becomes when width and depth change places.
std::string WallOf(const std::string& wall, bool turned) {
  if (!turned) return wall;
  if (wall == "south") return "west";
  if (wall == "west") return "south";
  return wall == "north" ? "east" : "north";
}

// They stand before the others.
size_t CountPrimaries(const std::vector<const v1::Object*>& objects) {
  return static_cast<size_t>(std::ranges::count_if(
      objects, [](const v1::Object* object) { return object->role() == v1::OBJECT_ROLE_PRIMARY; }));
}

// What the recorded model's own call put an item onto, beside or under; null when no call says.
const v1::Object* HostByCalls(const RecordedRoom& room, const v1::Object& item) {
  for (const v1::ConstraintEdge& edge : room.graph.edges()) {
    bool about_it = false;
    const v1::Object* other = nullptr;
    for (const v1::Argument& argument : edge.arguments()) {
      if (argument.value().text() == item.id()) about_it = true;
      for (const v1::Object* object : room.FloorObjects()) {
        if (argument.value().text() == object->id()) other = object;
      }
    }
    if (about_it && other != nullptr) return other;
  }
  return nullptr;
}

// Limits of the answers, see protos/flair/model/v1/constraint_answers.proto.
constexpr int kMostPerObject = 12, kMostPairs = 200, kMostOfAPair = 8;

// As an answer writes it: "sage #7A8B6F".
std::string ColourText(const v1::Colour& colour) {
  return fmt::format("{} #{:02X}{:02X}{:02X}", colour.name(), colour.red(), colour.green(), colour.blue());
}

// The names in the prompt that mean objects of that name. Those that are called alike (two bookshelves of two sizes)
// share their looks.
std::vector<std::string> NamesFor(const std::string& key, const std::vector<std::string>& names) {
  std::vector<std::string> found;
  for (const std::string& name : names) {
    if (NameKey(name) == key) found.push_back(name);
  }
  return found;
}

model::v1::ObjectSentencesAnswer& EntryFor(const std::string& name, bool must, model::v1::IntraAnswer& answer) {
  for (model::v1::ObjectSentencesAnswer& entry : *answer.mutable_objects()) {
    if (entry.object() == name && (must ? entry.must_size() : entry.should_size()) < kMostPerObject) return entry;
  }
  model::v1::ObjectSentencesAnswer& entry = *answer.add_objects();
  entry.set_object(name);
  return entry;
}

}  // namespace

RecordedAnswers::RecordedAnswers(const RecordedRoom& room, const Handbook& handbook)
    : room_(room),
      handbook_(handbook),
      furniture_(handbook),
      floor_(room.FloorObjects()),
      tertiaries_(room.Tertiaries()),
      primary_count_(CountPrimaries(floor_)),
      floor_names_(floor_) {
  for (const v1::Zone& zone : room.graph.zone_plan().zones()) zone_ids_.push_back(zone.id());
}

model::v1::RoomAnswer RecordedAnswers::Room() const {
  const v1::Room& room = room_.graph.room();
  const v1::Point2& far = room.floor().vertices(2);
  model::v1::RoomAnswer answer;
  const absl::StatusOr<BriefFacts> facts = ReadBrief(room_.brief, handbook_);
  answer.set_room_type(facts.ok() && facts->archetype_named ? facts->archetype->name() : "room");
  // Some rooms were recorded the other way round than their brief says.
  const bool turned = facts.ok() && facts->size.width_m == far.y_m() && facts->size.depth_m == far.x_m();
  answer.set_width_m(turned ? far.y_m() : far.x_m());
  answer.set_depth_m(turned ? far.x_m() : far.y_m());
  for (const v1::Opening& opening : room.openings()) {
    const bool window = opening.kind() == v1::OPENING_KIND_WINDOW;
    model::v1::OpeningAnswer& made = *answer.add_openings();
    made.set_kind(window ? "window" : "door");
    made.set_wall(WallOf(opening.wall(), turned));
    made.set_position(PositionOf(room, opening.wall(), opening.offset_m() + opening.width_m() / 2));
    made.set_width_m(Rounded(opening.width_m()));
    if (!window) made.set_swing("inward");
  }
  for (const v1::Socket& socket : room.sockets()) {
    model::v1::SocketAnswer& made = *answer.add_sockets();
    made.set_wall(WallOf(socket.wall(), turned));
    made.set_position(PositionOf(room, socket.wall(), socket.offset_m()));
  }
  return answer;
}

model::v1::ZonesAnswer RecordedAnswers::Zones() const {
  model::v1::ZonesAnswer answer;
  for (const v1::Zone& zone : room_.graph.zone_plan().zones()) {
    model::v1::ZoneAnswer& made = *answer.add_zones();
    made.set_name(zone.name());
    std::string things;
    for (const v1::Object* object : floor_) {
      if (object->zone_id() != zone.id() || object->role() != v1::OBJECT_ROLE_PRIMARY) continue;
      things += (things.empty() ? "" : ", ") + PlainName(object->name());
    }
    made.set_purpose(things.empty() ? fmt::format("For {}.", zone.name()) : fmt::format("Lives by the {}.", things));
  }
  return answer;
}

double RecordedAnswers::HeightOf(const v1::Object& object) const {
  double height_m = object.role() != v1::OBJECT_ROLE_TERTIARY  ? kFloorHeight_m
                    : object.kind() == v1::OBJECT_KIND_SURFACE ? kItemHeight_m
                    : object.kind() == v1::OBJECT_KIND_WALL    ? kWallHeight_m
                    : object.kind() == v1::OBJECT_KIND_CEILING ? kLampHeight_m
                                                               : kRugHeight_m;
  const hb::Furniture* known = furniture_.Find(object.name());
  if (known != nullptr && known->height_m().typical() > 0) height_m = known->height_m().typical();
  return std::min(height_m, room_.graph.room().height_m() - 0.2);
}

model::v1::FloorObjectsAnswer RecordedAnswers::FloorObjects() const {
  model::v1::FloorObjectsAnswer answer;
  std::vector<const v1::Object*> first;  // of each line
  std::vector<int> counts;
  for (const v1::Object* object : floor_) {
    const auto same = std::ranges::find_if(first, [&](const v1::Object* o) { return Alike(*o, *object); });
    if (same != first.end()) {
      ++counts[static_cast<size_t>(same - first.begin())];
    } else {
      first.push_back(object);
      counts.push_back(1);
    }
  }
  for (size_t i = 0; i < first.size(); ++i) {
    const v1::Object& object = *first[i];
    model::v1::FloorObjectAnswer& made = *answer.add_objects();
    made.set_name(NameFor(object, counts[i]));
    made.set_zone(object.zone_id());
    made.set_primary(object.role() == v1::OBJECT_ROLE_PRIMARY);
    made.set_count(counts[i]);
    made.set_width_m(object.width_m());
    made.set_depth_m(object.depth_m());
    made.set_height_m(HeightOf(object));
  }
  return answer;
}

model::v1::TertiaryAnswer RecordedAnswers::Tertiary(const v1::Object& object, const std::string& placement,
                                                    const std::vector<std::string>& hosts) const {
  model::v1::TertiaryAnswer made;
  made.set_name(NameFor(object, 1));
  made.set_kind(WordOf(object.kind()));
  if (!hosts.empty()) made.set_at(hosts.front());
  made.set_count(1);
  made.set_width_m(object.width_m());
  made.set_depth_m(object.depth_m());
  made.set_height_m(HeightOf(object));
  made.set_placement(placement);
  if (!placement.empty()) return made;
  const char* const where = object.kind() == v1::OBJECT_KIND_SURFACE ? "on" : "near";
  made.set_placement(hosts.empty() ? fmt::format("The {} goes where it fits.", made.name())
                                   : fmt::format("The {} is {} the {}.", made.name(), where, hosts.front()));
  return made;
}

model::v1::TertiariesAnswer RecordedAnswers::Tertiaries(std::string_view prompt, Conversion& conversion) const {
  const PromptIds ids(floor_, ReadPromptObjects(prompt));
  const std::vector<RecordedPlacement> placements =
      ReadTertiaryText(room_.Text("tertiary"), tertiaries_, floor_names_, conversion);
  model::v1::TertiariesAnswer answer;
  for (size_t i = 0; i < tertiaries_.size(); ++i) {
    const v1::Object& object = *tertiaries_[i];
    const RecordedPlacement& placement = placements[i];
    // Several of a kind that one item lists.
    if (i > 0 && placement.line != 0 && placement.line == placements[i - 1].line &&
        Alike(object, *tertiaries_[i - 1])) {
      model::v1::TertiaryAnswer& last = *answer.mutable_objects(answer.objects_size() - 1);
      last.set_count(last.count() + 1);
      continue;
    }
    std::vector<std::string> hosts = ids.NamesOf(placement.hosts);
    if (const v1::Object* host = hosts.empty() ? HostByCalls(room_, object) : nullptr; host != nullptr) {
      hosts = ids.NamesOf({static_cast<int>(std::ranges::find(floor_, host) - floor_.begin())});
    }
    *answer.add_objects() = Tertiary(object, placement.text, hosts);
    if (placement.text.empty()) {
      conversion.Keep("tertiary", 0, object.name(), "is in no item of the text; it goes where its call says");
    }
  }
  return answer;
}

std::vector<RecordedSentence> RecordedAnswers::Sentences(ConstraintTextKind kind, Conversion& conversion) const {
  const auto is_primary = [&](int object) { return static_cast<size_t>(object) < primary_count_; };
  const auto read = [&](std::string name) {
    name += kind == ConstraintTextKind::kIntra ? "_intra" : "_inter";
    if (!room_.Text(name + "_clean").empty()) name += "_clean";
    return ReadConstraintText({name, room_.Text(name), kind, floor_names_, zone_ids_}, conversion);
  };
  std::vector<RecordedSentence> sentences = read("primary");
  // The first list is of the primaries: a secondary of the same name is not meant.
  for (RecordedSentence& sentence : sentences) {
    const std::vector<int> named = sentence.objects;
    std::erase_if(sentence.objects, [&](int object) {
      return !is_primary(object) && std::ranges::any_of(named, [&](int other) {
        return is_primary(other) && NameOf(other) == NameOf(object);
      });
    });
  }
  for (RecordedSentence& sentence : read("secondary")) {
    // And the other way round.
    std::vector<int>& objects = sentence.objects;
    if (kind == ConstraintTextKind::kIntra && !std::ranges::all_of(objects, is_primary)) {
      std::erase_if(objects, is_primary);
    }
    sentences.push_back(std::move(sentence));
  }
  return sentences;
}

std::string RecordedAnswers::NameOf(int object) const { return NameKey(floor_[static_cast<size_t>(object)]->name()); }

model::v1::IntraAnswer RecordedAnswers::Intra(std::string_view prompt, Conversion& conversion) const {
  const PromptIds ids(floor_, ReadPromptObjects(prompt));
  model::v1::IntraAnswer answer;
  for (const RecordedSentence& sentence : Sentences(ConstraintTextKind::kIntra, conversion)) {
    const std::vector<std::string> names = ids.NamesOf(sentence.objects);
    if (names.empty()) {
      conversion.Unconvert("intra", sentence.text, "its object was left out");
      continue;
    }
    for (const std::string& name : names) {
      model::v1::ObjectSentencesAnswer& entry = EntryFor(name, sentence.must, answer);
      *(sentence.must ? entry.add_must() : entry.add_should()) = sentence.text;
    }
  }
  return answer;
}

model::v1::InterAnswer RecordedAnswers::Inter(std::string_view prompt, Conversion& conversion) const {
  const PromptIds ids(floor_, ReadPromptObjects(prompt));
  model::v1::InterAnswer answer;
  for (const RecordedSentence& sentence : Sentences(ConstraintTextKind::kInter, conversion)) {
    const std::vector<std::string> names = ids.NamesOf(sentence.objects);
    if (names.empty() || answer.constraints_size() == kMostPairs) {
      conversion.Unconvert("inter", sentence.text, names.empty() ? "its objects were left out" : "one too many");
      continue;
    }
    model::v1::PairAnswer entry;
    for (const std::string& name : names) {
      if (entry.objects_size() < kMostOfAPair) entry.add_objects(name);
    }
    const auto same = [&](const model::v1::PairAnswer& last) {
      return std::equal(last.objects().begin(), last.objects().end(), entry.objects().begin(), entry.objects().end()) &&
             (sentence.must ? last.must_size() : last.should_size()) < kMostPerObject;
    };
    const bool again = answer.constraints_size() > 0 && same(*answer.constraints().rbegin());
    if (!again) *answer.add_constraints() = entry;
    model::v1::PairAnswer& pair = *answer.mutable_constraints(answer.constraints_size() - 1);
    *(sentence.must ? pair.add_must() : pair.add_should()) = sentence.text;
  }
  return answer;
}

model::v1::StyleAnswer RecordedAnswers::Style(const std::vector<std::string>& names) const {
  model::v1::StyleAnswer answer;
  const v1::ObjectList& objects = room_.graph.object_list();
  const absl::StatusOr<v1::StyleSheet> style = ChooseStyle(room_.brief, room_.graph.room(), objects, handbook_);
  if (!style.ok()) return answer;
  answer.set_name(style->name());
  answer.set_summary(style->summary());
  for (const v1::Colour& colour : style->palette()) answer.add_palette(ColourText(colour));
  for (const v1::SurfaceStyle& surface : style->surfaces()) {
    model::v1::SurfaceAnswer& made = *answer.add_surfaces();
    made.set_surface(surface.surface());
    made.set_material(surface.material());
    made.set_colour(ColourText(surface.colour()));
  }
  std::map<std::string, std::string> keys;
  for (const v1::Object& object : objects.objects()) keys[object.id()] = NameKey(object.name());
  std::set<std::string> seen;
  for (const v1::ObjectStyle& object : style->objects()) {
    const auto key = keys.find(object.subject_id());
    std::vector<std::string> of = key == keys.end() ? std::vector<std::string>{} : NamesFor(key->second, names);
    std::erase_if(of, [&](const std::string& name) { return !seen.insert(name).second; });
    if (of.empty()) continue;
    model::v1::LookAnswer& look = *answer.add_looks();
    for (const std::string& name : of) look.add_of(name);
    look.set_material(object.material());
    look.set_colour(ColourText(object.colour()));
  }
  return answer;
}

}  // namespace flair::language
