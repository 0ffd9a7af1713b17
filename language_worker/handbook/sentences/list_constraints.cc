// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/sentences/list_constraints.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "language_worker/handbook/program/room_program.h"
#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/rooms/wall_run.h"
#include "language_worker/handbook/rooms/walls.h"
#include "language_worker/handbook/sentences/place_writer.h"
#include "language_worker/handbook/sentences/sentence_writer.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {

namespace {

bool Selects(const hb::Selector& selector, const v1::Object& object, const hb::Furniture* furniture,
             const std::string& kin, bool first_on_host) {
  const hb::Furniture& facts = furniture != nullptr ? *furniture : hb::Furniture::default_instance();
  if (selector.kinds().empty()) {
    if (object.kind() != v1::OBJECT_KIND_FLOOR || object.walk_over()) return false;
  } else if (!Includes(selector.kinds(), static_cast<int>(object.kind()))) {
    return false;
  }
  if (!selector.backs().empty() && !Includes(selector.backs(), static_cast<int>(facts.back()))) return false;
  if (!selector.categories().empty() && !Includes(selector.categories(), object.category())) return false;
  const auto names = [&](const auto& classes) { return Includes(classes, object.name()) || Includes(classes, kin); };
  if (!selector.furniture().empty() && !names(selector.furniture())) return false;
  if (names(selector.except_furniture())) return false;
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
        base_of_own_(facts.base_of_own),
        program_(MakeRoomProgram(facts, handbook, FloorArea(room), choice)),
        writer_(room, zones, objects, handbook, program_, choice, spoken),
        place_writer_(room, program_, places_, writer_),
        run_(PlanRun(room, objects, facts, handbook, choice)),
        form_kept_(HasForm(run_, facts.run_form)),
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
    for (const v1::Sentence& sentence : place_writer_.WriteRun(run_, group)) {
      sentences_.push_back(sentence);
      uses_.push_back({sentence, {"wall", "walls", "corner", "corners"}});
      topics.insert({"back", "run", "corner", "draught"});
      // One stands before what is set into the worktop; at a corner before no more of it.
      if (furniture->run() == hb::RUN_PART_WORKTOP) topics.insert("access");
    }
    if (WriteEntrySentence(name, group)) topics.insert("place");
    if (writer_.IsTogether(group)) {
      WriteRules(true, group, topics);
      topics.insert({"light", "socket", "way", "before", "front"});
      if (furniture == nullptr || furniture->back() != hb::BACK_RULE_WALL) topics.insert("back");
    }
    // Rows look straight ahead, and an audience is at no desk.
    if (writer_.StandsInOwnRows(group)) topics.insert({"place", "facing", "near", "back", "wall"});
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
    // What has a place looks at what is there.
    if (topics.contains("place")) topics.insert("facing");
    WriteRules(false, group, topics);
    if (writer_.HasWays(group)) WriteRules(true, group, topics);
  }

  // The general rules: those about neighbours, which say how islands stand, or the others.
  void WriteRules(bool of_neighbours, const Group& group, std::set<std::string>& topics) {
    const std::string& name = group.front()->name();
    const hb::Furniture* furniture = handbook_.FindFurniture(name);
    for (const hb::GeneralRule& rule : handbook_.contents().general_rules()) {
      if ((rule.relation().pairing() == hb::PAIRING_NEIGHBOUR) != of_neighbours) continue;
      if (rule.selector().in_rows() && !writer_.StandsInOwnRows(group)) continue;
      // Those with ways between them have a neighbour each.
      if (rule.selector().in_rows() && rule.relation().topic() == "row" && writer_.HasWays(group)) continue;
      if (Selects(rule.selector(), *group.front(), furniture, KinOf(name), TakesCentre(objects_, *group.front()))) {
        WriteLevel({&rule.relation()}, group, topics);
      }
    }
  }

  // What the brief itself says of their place settles its topics.
  void WritePlaces(const std::string& name, const Group& group, std::set<std::string>& topics) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Place& place = places_[i];
      if (!IsMeant(*place.furniture, name)) continue;
      // Those on either side of a table face each other over it.
      if (place.asked->relation().text() == "The {objects} face each other." && writer_.IsSeated(group)) {
        kept_[i] = true;
        continue;
      }
      const std::vector<v1::Sentence> written = place_writer_.Write(place, group);
      for (v1::Sentence sentence : written) {
        sentence.set_origin(v1::SENTENCE_ORIGIN_BRIEF);
        // Which door or window it is, is in the words alone.
        const bool opening =
            sentence.text().find(" door") != std::string::npos || sentence.text().find(" window") != std::string::npos;
        if (opening && !place.side.empty()) sentence.clear_meaning();
        // In the brief's own words, so that whoever reads of it knows which wish it is.
        constexpr std::string_view kIt = "asks for it";
        if (const std::size_t at = sentence.reason().find(kIt); at != std::string::npos)
          sentence.mutable_reason()->replace(at, kIt.size(), fmt::format("asks for \"{}\"", place.Words()));
        sentences_.push_back(std::move(sentence));
      }
      if (written.empty()) continue;
      kept_[i] = true;
      topics.insert("shared");
      topics.insert(place.asked->silences().begin(), place.asked->silences().end());
      const bool in_row = std::ranges::any_of(
          written, [](const v1::Sentence& sentence) { return sentence.text().ends_with("side by side in a row."); });
      if (in_row || place.walls > 1 || place.which >= 0 || place.asked->parts() > 1) topics.insert("row");
    }
  }

  // Whether objects of that name are, or stand in for, what a brief names.
  bool IsMeant(const hb::Furniture& furniture, const std::string& name) const {
    if (furniture.name() == name) return true;
    return !writer_.groups().contains(furniture.name()) &&
           (Includes(WithSubstitutes(std::array{furniture.name()}, program_), name) || furniture.smaller() == name);
  }

  // Places of which no sentence came, of pieces that are there: the others are told of where they are left out.
  void RemarkOnPlaces(v1::ConstraintList& list) const {
    std::set<std::string> told;
    if (!form_kept_) {
      v1::Diagnostic& remark = *list.add_diagnostics();
      remark.set_severity(v1::SEVERITY_WARNING);
      remark.set_code("place_not_kept");
      remark.set_message(
          "The kitchen units do not go along the walls as the brief asks; doors leave no room for that.");
    }
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const bool there = std::ranges::any_of(
          writer_.groups(), [&](const auto& group) { return IsMeant(*places_[i].furniture, group.first); });
      if (kept_[i] || !there || !told.insert(places_[i].Words()).second) continue;
      v1::Diagnostic& remark = *list.add_diagnostics();
      remark.set_severity(v1::SEVERITY_WARNING);
      remark.set_code("place_not_kept");
      remark.set_message(fmt::format("The brief asks for \"{}\"; {}.", places_[i].Words(), WhyNotKept(places_[i])));
    }
  }

  std::string WhyNotKept(const Place& place) const {
    for (const hb::Furniture* piece : {place.target, place.other}) {
      if (piece != nullptr && !writer_.groups().contains(piece->name())) {
        return fmt::format("there is no {} in the room", piece->name());
      }
    }
    const hb::Condition& condition = place.asked->relation().condition();
    const auto group = writer_.groups().find(place.furniture->name());
    const int there = group == writer_.groups().end() ? 0 : static_cast<int>(group->second.size());
    if (condition.max_count() > 0 && there > condition.max_count())
      return fmt::format("that can be done for {}, and the room has {}", condition.max_count(), there);
    if (condition.min_count() > 1) return "the room does not have that many of them";
    return "the room has no such wall or pair of pieces";
  }

  // What is said of armchairs holds for the wing chairs of a brief.
  void Collect(const google::protobuf::RepeatedPtrField<hb::Relation>& relations, const std::string& name,
               Relations& collected) const {
    for (const hb::Relation& relation : relations) {
      if (relation.object() == name || relation.object() == KinOf(name)) collected.push_back(&relation);
    }
  }

  // The class that one named by the brief is a kind of; any other itself.
  const std::string& KinOf(const std::string& name) const {
    const auto base = base_of_own_.find(name);
    return base == base_of_own_.end() || base->second.empty() ? name : base->second;
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
  const std::map<std::string, std::string> base_of_own_;
  const RoomProgram program_;
  const SentenceWriter writer_;
  const PlaceWriter place_writer_;
  const std::vector<RunPlace> run_;  // of what has a part in one
  const bool form_kept_;
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
