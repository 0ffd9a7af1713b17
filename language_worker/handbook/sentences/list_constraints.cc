// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/sentences/list_constraints.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/room.pb.h"
#include "language_worker/handbook/program/room_program.h"
#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/rooms/walls.h"
#include "language_worker/handbook/sentences/fill.h"
#include "language_worker/handbook/sentences/sentence_writer.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {

namespace {

bool PlaceNames(const Place& place, std::string_view slot) {
  return place.asked->relation().text().find(slot) != std::string::npos;
}

// A wall as what "{wall}" stands for.
Slot TheWall(const v1::Room& room, int wall) {
  const std::string& name = room.walls(wall).name();
  v1::Participant participant;
  participant.set_wall(name);
  return {name.starts_with("wall") ? name : fmt::format("the {} wall", name), {participant}};
}

bool HasOpenings(const v1::Room& room, int wall) {
  return std::ranges::any_of(room.openings(),
                             [&](const v1::Opening& one) { return one.wall() == room.walls(wall).name(); });
}

// Writes what a brief says of the places of its pieces, for the walls and pieces that the room has. The arguments must
// outlive it.
class PlaceWriter {
 public:
  PlaceWriter(const v1::Room& room, const RoomProgram& program, const SentenceWriter& writer)
      : room_(room), program_(program), writer_(writer) {}

  // The sentences about those of `group` whose place it is, without ids; empty when the room has none of what the place
  // is told by.
  std::vector<v1::Sentence> Write(const Place& place, const Group& group) const {
    const Group subjects = SubjectsOf(place, group);
    if (subjects.empty()) return {};
    if (!place.asked->text_of_desks().empty() && subjects.front()->category() == "desk") {
      const std::vector<v1::Sentence> sentences = WriteOfDesks(place, subjects);
      if (!sentences.empty()) return sentences;
    }
    if (PlaceNames(place, "{first}")) return WriteBetween(place, subjects);
    if (!place.side.empty() && PlaceNames(place, "in a corner")) return WriteCorner(place, subjects);
    if (PlaceNames(place, "{wall}") && place.said.ends_with("walls") && subjects.size() == 2) {
      return WriteOpposite(place, subjects);
    }
    Slots further;
    if (PlaceNames(place, "{wall}")) {
      const std::optional<int> wall = WallOf(room_, place.side);
      if (!wall && !place.side.empty()) return {};
      further["wall"] = wall ? TheWall(room_, *wall) : Slot{"a wall", {}};
    }
    hb::Relation relation = place.asked->relation();
    const hb::Carried carried = place.asked->carried();
    const bool on_a_top = carried != hb::CARRIED_UNSPECIFIED && subjects.front()->kind() == v1::OBJECT_KIND_SURFACE;
    if (on_a_top && !writer_.IsCentral(*subjects.front()))
      relation.set_text("The {object} is on the {corner} corner of the {target}.");
    // What stands beside a thing stands on that one's host.
    if (place.target != nullptr && carried != hb::CARRIED_ALONG) relation.add_targets(place.target->name());
    return writer_.Write(relation, subjects, further);
  }

 private:
  // "One desk by the door": the group may be a part of all that have the name.
  Group SubjectsOf(const Place& place, const Group& group) const {
    if (place.which < 0) return group;
    const Group& all = writer_.groups().at(group.front()->name());
    const auto at = static_cast<std::size_t>(place.which);
    if (at >= all.size() || std::ranges::find(group, all[at]) == group.end()) return {};
    return {all[at]};
  }

  // Whoever sits at a desk looks over its back.
  std::vector<v1::Sentence> WriteOfDesks(const Place& place, const Group& group) const {
    hb::Relation relation = place.asked->relation();
    relation.set_text(place.asked->text_of_desks());
    if (place.target != nullptr) relation.add_targets(place.target->name());
    if (relation.text().find("{seat}") == std::string::npos) return writer_.Write(relation, group);
    relation.set_text(Fill(relation.text(), {{"seat", "{object}"}}));
    Group seats;
    for (const auto& [name, objects] : writer_.groups()) {
      for (const v1::Object* one : objects) {
        const bool here = one->zone_id() == group.front()->zone_id() && one->role() != v1::OBJECT_ROLE_TERTIARY;
        if (one->category() == "chair" && here && seats.size() < group.size()) seats.push_back(one);
      }
      if (!seats.empty()) break;
    }
    return seats.empty() ? std::vector<v1::Sentence>() : writer_.Write(relation, seats);
  }

  // "Two beds against opposite walls".
  std::vector<v1::Sentence> WriteOpposite(const Place& place, const Group& group) const {
    std::vector<v1::Sentence> sentences;
    for (std::size_t i = 0; i < group.size(); ++i) {
      const std::optional<int> wall = WallOf(room_, i == 0 ? "left" : "right");
      if (!wall) return {};
      sentences.push_back(
          writer_.WriteOne(place.asked->relation(), {group[i]}, {}, i, {{"wall", TheWall(room_, *wall)}}));
    }
    return sentences;
  }

  std::vector<v1::Sentence> WriteBetween(const Place& place, const Group& group) const {
    std::vector<v1::Sentence> sentences;
    for (const v1::Object* object : group) {
      const v1::Object* first = Neighbour(*place.target, *object, nullptr);
      const v1::Object* second = first == nullptr ? nullptr : Neighbour(*place.other, *object, first);
      if (second == nullptr) continue;
      v1::Sentence sentence =
          writer_.WriteOne(place.asked->relation(), {object}, {}, 0,
                           {{"first", writer_.SlotOf({first})}, {"second", writer_.SlotOf({second})}});
      sentence.add_subject_ids(first->id());
      sentence.add_subject_ids(second->id());
      sentence.set_scope(v1::SENTENCE_SCOPE_INTER);
      sentences.push_back(std::move(sentence));
    }
    return sentences;
  }

  // Into the one corner that is meant: its back on one wall, a side on the other.
  std::vector<v1::Sentence> WriteCorner(const Place& place, const Group& group) const {
    const std::optional<int> corner = CornerOf(room_, place.side);
    if (!corner) return writer_.Write(place.asked->relation(), group);
    const int after = *corner, before = (*corner + room_.walls_size() - 1) % room_.walls_size();
    // The back leaves windows and doors free where it can. Along a wall that begins in the corner the left side meets
    // the other one, along a wall that ends there the right side.
    const bool on_after = HasOpenings(room_, before) || !HasOpenings(room_, after);
    hb::Relation back = place.asked->relation(), side = back;
    back.set_text("The {object}'s back is against {wall}.");
    side.set_text(fmt::format("The {{object}}'s {} side is against {{wall}}.", on_after ? "left" : "right"));
    std::vector<v1::Sentence> sentences =
        writer_.Write(back, {group.front()}, {{"wall", TheWall(room_, on_after ? after : before)}});
    for (v1::Sentence& sentence :
         writer_.Write(side, {group.front()}, {{"wall", TheWall(room_, on_after ? before : after)}})) {
      sentences.push_back(std::move(sentence));
    }
    return sentences;
  }

  // One of that class, or of what came in its place: of the object's own zone first, and not `other`.
  const v1::Object* Neighbour(const hb::Furniture& furniture, const v1::Object& object, const v1::Object* other) const {
    google::protobuf::RepeatedPtrField<std::string> classes;
    *classes.Add() = furniture.name();
    const v1::Object* best = nullptr;
    for (const std::string& name : WithSubstitutes(classes, program_)) {
      const auto found = writer_.groups().find(name);
      if (found == writer_.groups().end()) continue;
      for (const v1::Object* one : found->second) {
        if (one == &object || one == other) continue;
        if (best == nullptr || (best->zone_id() != object.zone_id() && one->zone_id() == object.zone_id())) best = one;
      }
    }
    return best;
  }

  const v1::Room& room_;
  const RoomProgram& program_;
  const SentenceWriter& writer_;
};

bool Selects(const hb::Selector& selector, const v1::Object& object, const hb::Furniture* furniture,
             bool first_on_host) {
  const hb::Furniture& facts = furniture != nullptr ? *furniture : hb::Furniture::default_instance();
  if (selector.kinds().empty()) {
    if (object.kind() != v1::OBJECT_KIND_FLOOR || object.walk_over()) return false;
  } else if (!Includes(selector.kinds(), static_cast<int>(object.kind()))) {
    return false;
  }
  if (!selector.backs().empty() && !Includes(selector.backs(), static_cast<int>(facts.back()))) return false;
  if (!selector.categories().empty() && !Includes(selector.categories(), object.category())) return false;
  if (!selector.furniture().empty() && !Includes(selector.furniture(), object.name())) return false;
  if (Includes(selector.except_furniture(), object.name())) return false;
  if (selector.has_host_center() && selector.host_center() != first_on_host) return false;
  if (object.height_m() < selector.min_height_m()) return false;
  if (selector.max_height_m() > 0 && object.height_m() >= selector.max_height_m()) return false;
  return facts.clear_front_m() >= selector.min_clear_front_m() &&
         facts.clear_sides_m() >= selector.min_clear_sides_m() && facts.clear_back_m() >= selector.min_clear_back_m();
}

class ConstraintLister {
 public:
  ConstraintLister(const BriefFacts& facts, const v1::Room& room, const v1::ZonePlan& zones,
                   const v1::ObjectList& objects, const Handbook& handbook, const Choice& choice,
                   const v1::ObjectList* spoken = nullptr)
      : handbook_(handbook),
        choice_(choice),
        objects_(objects),
        places_(facts.places),
        program_(MakeRoomProgram(facts, handbook, FloorArea(room), choice)),
        writer_(room, zones, objects, handbook, program_, choice, spoken),
        place_writer_(room, program_, writer_),
        kept_(facts.places.size(), false) {}

  // What of all that is how one uses the pieces.
  std::vector<UseSentence> Uses() {
    WriteAll();
    return std::move(uses_);
  }

  v1::ConstraintList List() {
    WriteAll();
    // Ids follow the translation passes: the room first, then pairs, then tertiaries.
    std::stable_sort(sentences_.begin(), sentences_.end(),
                     [](const v1::Sentence& a, const v1::Sentence& b) { return a.scope() < b.scope(); });
    v1::ConstraintList list;
    for (v1::Sentence& sentence : sentences_) {
      sentence.set_id(fmt::format("s{}", list.sentences_size() + 1));
      *list.add_sentences() = sentence;
    }
    RemarkOnPlaces(list);
    return list;
  }

 private:
  using Relations = std::vector<const hb::Relation*>;

  void WriteAll() {
    std::set<std::string> done;
    for (const v1::Object& object : objects_.objects()) {
      if (done.insert(object.name()).second) WriteParts(object.name(), writer_.groups().at(object.name()));
    }
  }

  // Objects of one name that are attached in the same way: with a host or without, in the middle of its top or at its
  // edge, on the floor of the same zone: the chairs at the meeting table are others than those at the desks.
  void WriteParts(const std::string& name, const Group& group) {
    std::map<std::tuple<bool, bool, std::string>, Group> parts;
    for (const v1::Object* object : group) {
      const bool on_floor = object->kind() == v1::OBJECT_KIND_FLOOR;
      parts[{object->host_id().empty(), !TakesCentre(objects_, *object), on_floor ? object->zone_id() : ""}].push_back(
          object);
    }
    for (const auto& [attachment, part] : parts) WriteGroup(name, part);
  }

  // Sentences of the room's kind, its themes and needs; then of the class; then the general rules: what is said about a
  // topic at one level is not said again at a later one.
  void WriteGroup(const std::string& name, const Group& group) {
    const hb::Furniture* furniture = handbook_.FindFurniture(name);
    std::set<std::string> topics;
    WritePlaces(name, group, topics);
    if (WriteEntrySentence(name, group)) topics.insert("place");
    Relations special;
    for (const hb::Changes* changes : program_.changes) Collect(changes->relations(), name, special);
    Collect(program_.archetype->relations(), name, special);
    for (const FurtherKind& also : program_.also) Collect(also.archetype->relations(), name, special);
    WriteLevel(special, group, topics);
    Relations own;
    if (furniture != nullptr) {
      for (const hb::Relation& relation : furniture->relations()) own.push_back(&relation);
    }
    WriteLevel(own, group, topics);
    for (const hb::GeneralRule& rule : handbook_.contents().general_rules()) {
      if (Selects(rule.selector(), *group.front(), furniture, TakesCentre(objects_, *group.front()))) {
        WriteLevel({&rule.relation()}, group, topics);
      }
    }
  }

  // What the brief itself says of their place settles its topics.
  void WritePlaces(const std::string& name, const Group& group, std::set<std::string>& topics) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Place& place = places_[i];
      if (!IsMeant(*place.furniture, name)) continue;
      const std::vector<v1::Sentence> written = place_writer_.Write(place, group);
      for (v1::Sentence sentence : written) {
        sentence.set_origin(v1::SENTENCE_ORIGIN_BRIEF);
        sentences_.push_back(std::move(sentence));
      }
      if (written.empty()) continue;
      kept_[i] = true;
      topics.insert(place.asked->silences().begin(), place.asked->silences().end());
    }
  }

  // Whether objects of that name are, or stand in for, what a brief names.
  bool IsMeant(const hb::Furniture& furniture, const std::string& name) const {
    if (furniture.name() == name) return true;
    google::protobuf::RepeatedPtrField<std::string> classes;
    *classes.Add() = furniture.name();
    return !writer_.groups().contains(furniture.name()) &&
           (Includes(WithSubstitutes(classes, program_), name) || furniture.smaller() == name);
  }

  // Places of which no sentence came, of pieces that are there: the others are told of where they are left out.
  void RemarkOnPlaces(v1::ConstraintList& list) const {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const bool there = std::ranges::any_of(
          writer_.groups(), [&](const auto& group) { return IsMeant(*places_[i].furniture, group.first); });
      if (kept_[i] || !there) continue;
      v1::Diagnostic& remark = *list.add_diagnostics();
      remark.set_severity(v1::SEVERITY_WARNING);
      remark.set_code("place_not_kept");
      remark.set_message(fmt::format("The brief wants \"{} {}\"; {}.", places_[i].furniture->name(), places_[i].said,
                                     WhyNotKept(places_[i])));
    }
  }

  std::string WhyNotKept(const Place& place) const {
    for (const hb::Furniture* piece : {place.target, place.other}) {
      if (piece != nullptr && !writer_.groups().contains(piece->name())) {
        return fmt::format("there is no {} in the room", piece->name());
      }
    }
    if (place.asked->relation().condition().min_count() > 1) return "the room does not have that many of them";
    return "the room has no such wall or pair of pieces";
  }

  static void Collect(const google::protobuf::RepeatedPtrField<hb::Relation>& relations, const std::string& name,
                      Relations& collected) {
    for (const hb::Relation& relation : relations) {
      if (relation.object() == name) collected.push_back(&relation);
    }
  }

  // The placement that a program's line gives of its own.
  bool WriteEntrySentence(const std::string& name, const Group& group) {
    for (const auto* items : {&program_.floor_items, &program_.tertiary_items}) {
      for (const ProgramItem& item : *items) {
        if (item.furniture->name() != name || item.entry == nullptr || item.entry->sentence().empty()) continue;
        hb::Relation relation;
        relation.set_text(item.entry->sentence());
        relation.set_reason(item.entry->reason());
        const std::vector<v1::Sentence> written = writer_.Write(relation, group);
        sentences_.insert(sentences_.end(), written.begin(), written.end());
        if (!written.empty()) return true;
      }
    }
    return false;
  }

  void WriteLevel(const Relations& relations, const Group& group, std::set<std::string>& topics) {
    const std::set<std::string> said_before = topics;
    const bool tertiary = group.front()->role() == v1::OBJECT_ROLE_TERTIARY;
    std::map<std::string, std::vector<std::vector<v1::Sentence>>> choices;
    std::vector<std::string> choice_order;
    for (const hb::Relation* relation : relations) {
      if (!relation->topic().empty() && said_before.count(relation->topic()) > 0) continue;
      // [Paper] One constraint per tertiary object: the first that can be written says where it goes.
      if (tertiary && !topics.empty() && choices.count(relation->choice()) == 0) continue;
      std::vector<v1::Sentence> written = writer_.Write(*relation, group);
      if (written.empty()) continue;
      topics.insert(relation->topic());
      if (relation->use()) {
        const std::vector<std::string> overrules(relation->overrules().begin(), relation->overrules().end());
        for (const v1::Sentence& sentence : written) uses_.push_back({sentence, overrules});
      }
      if (relation->choice().empty()) {
        sentences_.insert(sentences_.end(), written.begin(), written.end());
      } else {
        if (choices.count(relation->choice()) == 0) choice_order.push_back(relation->choice());
        choices[relation->choice()].push_back(std::move(written));
      }
    }
    for (const std::string& key : choice_order) {
      const auto& options = choices[key];
      const auto& picked = options[choice_.Index("sentence." + group.front()->name() + "." + key, options.size())];
      sentences_.insert(sentences_.end(), picked.begin(), picked.end());
    }
  }

  const Handbook& handbook_;
  const Choice& choice_;
  const v1::ObjectList& objects_;
  const std::vector<Place> places_;
  const RoomProgram program_;
  const SentenceWriter writer_;
  const PlaceWriter place_writer_;
  std::vector<bool> kept_;  // of a place: sentences were written
  std::vector<v1::Sentence> sentences_;
  std::vector<UseSentence> uses_;
};

}  // namespace

absl::StatusOr<v1::ConstraintList> ListConstraints(const v1::Brief& brief, const v1::Room& room,
                                                   const v1::ZonePlan& zones, const v1::ObjectList& objects,
                                                   const Handbook& handbook) {
  ASSIGN_OR_RETURN(const BriefFacts facts, ReadBrief(brief, handbook));
  const Choice choice(brief.seed(), brief.text());
  return ConstraintLister(facts, room, zones, objects, facts.HandbookOr(handbook), choice).List();
}

absl::StatusOr<std::vector<UseSentence>> ListUses(const v1::Brief& brief, const v1::Room& room,
                                                  const v1::ZonePlan& zones, const v1::ObjectList& objects,
                                                  const v1::ObjectList& spoken, const Handbook& handbook) {
  ASSIGN_OR_RETURN(const BriefFacts facts, ReadBrief(brief, handbook));
  const Choice choice(brief.seed(), brief.text());
  return ConstraintLister(facts, room, zones, objects, facts.HandbookOr(handbook), choice, &spoken).Uses();
}

}  // namespace flair::language
