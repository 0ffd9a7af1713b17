// SPDX-License-Identifier: GPL-3.0-or-later
// What sentences call objects, their zones and the corners that they take.
#include "language_worker/handbook/sentences/sentence_writer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "english/words.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/sentences/fill.h"

namespace flair::language {

namespace {

constexpr std::array<const char*, 13> kNumbers = {"no",    "one",   "two",  "three", "four",   "five",  "six",
                                                  "seven", "eight", "nine", "ten",   "eleven", "twelve"};

std::string Metres(double length_m) { return fmt::format("{:g} m", length_m); }

// "The books is on …" -> "The books are on …" for names that are plural by themselves.
std::string WithVerb(std::string text, const std::string& object, bool plural) {
  constexpr std::array<std::array<std::string_view, 2>, 8> kVerbs = {{{"is", "are"},
                                                                      {"hangs", "hang"},
                                                                      {"stands", "stand"},
                                                                      {"lies", "lie"},
                                                                      {"faces", "face"},
                                                                      {"has", "have"},
                                                                      {"does", "do"},
                                                                      {"keeps", "keep"}}};
  const std::string opening = "The " + object + " ";
  if (!plural || text.compare(0, opening.size(), opening) != 0) return text;
  for (const auto& [one, many] : kVerbs) {
    const std::string verb = std::string(one) + " ";
    if (text.compare(opening.size(), verb.size(), verb) == 0) {
      return text.replace(opening.size(), one.size(), many);
    }
  }
  return text;
}

// Those of a row stand from left to right.
const v1::Object* MiddleOf(const Group& row) { return row[(row.size() - 1) / 2]; }

}  // namespace

SentenceWriter::SentenceWriter(const v1::Room& room, const v1::ZonePlan& zones, const v1::ObjectList& objects,
                               const Handbook& handbook, const RoomProgram& program, const Choice& choice,
                               const v1::ObjectList* spoken)
    : room_(room),
      zones_(zones),
      objects_(objects),
      handbook_(handbook),
      program_(program),
      choice_(choice),
      area_m2_(FloorArea(room)) {
  for (const v1::Object& object : objects.objects()) groups_[object.name()].push_back(&object);
  for (const v1::Object& object : (spoken != nullptr ? *spoken : objects).objects()) {
    spoken_by_id_[object.id()] = object.name();
    ids_by_spoken_[object.name()].push_back(object.id());
  }
}

bool SentenceWriter::Applies(const hb::Relation& relation, const Group& group) const {
  const hb::Condition& condition = relation.condition();
  if (group.empty() || !Holds(condition, *program_.archetype, area_m2_, choice_, relation.text())) return false;
  const int count = static_cast<int>(group.size());
  if (count < condition.min_count() || (condition.max_count() > 0 && count > condition.max_count())) return false;
  for (const std::string& name : condition.with()) {
    const std::vector<std::string> names = WithSubstitutes(std::array{name}, program_);
    if (std::ranges::none_of(names, [&](const std::string& one) { return groups_.contains(one); })) return false;
  }
  for (const std::string& name : WithSubstitutes(condition.without(), program_)) {
    if (groups_.count(name) == 0) continue;
    // Elsewhere in the room it is no matter for those whose partner is at hand: the chair at its desk does not mind the
    // meeting table.
    const bool elsewhere = !IsInZoneOf(*group.front(), name) && HasPartnerInZone(relation, *group.front());
    if (!elsewhere) return false;
  }
  if (!condition.zones().empty() && !Includes(condition.zones(), ZoneName(*group.front()))) return false;
  return !condition.needs_window() || std::ranges::any_of(room_.openings(), [](const auto& opening) {
    return opening.kind() == v1::OPENING_KIND_WINDOW;
  });
}

bool SentenceWriter::IsInZoneOf(const v1::Object& object, const std::string& name) const {
  const auto group = groups_.find(name);
  return group != groups_.end() && std::ranges::any_of(group->second, [&](const v1::Object* other) {
           return other->id() != object.id() && other->zone_id() == object.zone_id();
         });
}

bool SentenceWriter::HasPartnerInZone(const hb::Relation& relation, const v1::Object& object) const {
  if (object.role() == v1::OBJECT_ROLE_TERTIARY) return false;
  const std::vector<std::string> names = WithSubstitutes(relation.targets(), program_);
  return std::ranges::any_of(names, [&](const std::string& name) { return IsInZoneOf(object, name); });
}

bool SentenceWriter::FindTargets(const hb::Relation& relation, const v1::Object& object, Group& targets) const {
  const bool needs_target = relation.text().find("{target") != std::string::npos;
  if (relation.targets().empty()) {
    if (!needs_target) return true;
    for (const v1::Object& host : objects_.objects()) {
      if (host.id() == object.host_id()) targets = {&host};
    }
    return !targets.empty();
  }
  if (object.role() == v1::OBJECT_ROLE_TERTIARY) {
    // What hangs or stands somewhere is paired with its own host; a wall piece without one belongs to no other object.
    if (object.host_id().empty() && object.kind() == v1::OBJECT_KIND_WALL && needs_target) return false;
    for (const v1::Object& host : objects_.objects()) {
      if (host.id() != object.host_id()) continue;
      const std::vector<std::string> names = WithSubstitutes(relation.targets(), program_);
      if (std::find(names.begin(), names.end(), host.name()) == names.end()) continue;
      targets = {&host};
      return true;
    }
  }
  // Partners of the same zone come first, of whatever class; others only when there are none.
  const std::vector<std::string> names = WithSubstitutes(relation.targets(), program_);
  for (const bool near : {true, false}) {
    for (const std::string& name : names) {
      const auto group = groups_.find(name);
      if (group == groups_.end()) continue;
      for (const v1::Object* target : group->second) {
        const bool there = target->role() != v1::OBJECT_ROLE_TERTIARY && target->zone_id() == object.zone_id();
        if (target->id() != object.id() && (!near || there)) targets.push_back(target);
      }
      if (!targets.empty()) return true;
    }
  }
  return false;
}

std::vector<v1::Sentence> SentenceWriter::Write(const hb::Relation& relation, const Group& group,
                                                const Slots& further) const {
  std::vector<v1::Sentence> sentences;
  if (!Applies(relation, group)) return sentences;
  if (relation.pairing() == hb::PAIRING_TOGETHER) return WriteTogether(relation, group, further);
  if (relation.pairing() == hb::PAIRING_NEIGHBOUR) return WriteNeighbours(relation, group);
  if (relation.pairing() == hb::PAIRING_ROW_BEFORE || relation.pairing() == hb::PAIRING_FRONT_ROW) {
    Group targets = RowBefore(*group.front());
    const bool front = relation.pairing() == hb::PAIRING_FRONT_ROW;
    const v1::Object* middle = MiddleOf(group);
    if (targets.empty() != front || (front && !FindTargets(relation, *middle, targets))) return sentences;
    sentences.push_back(WriteOne(relation, {middle}, front ? targets : Group{MiddleOf(targets)}, 0));
    // Beyond an aisle the last has one before it, too.
    if (!front && HasWays(group) && targets.size() == group.size())
      sentences.push_back(WriteOne(relation, {group.back()}, {targets.back()}, 1));
    return sentences;
  }
  const std::size_t count = relation.pairing() == hb::PAIRING_FIRST ? 1 : group.size();
  for (std::size_t i = 0; i < count; ++i) {
    Group targets;
    if (!FindTargets(relation, *group[i], targets)) continue;
    const auto most = static_cast<std::size_t>(relation.most_a_partner());
    if (most > 0 && i >= most * targets.size()) break;
    if (!targets.empty())
      std::rotate(targets.begin(), targets.begin() + static_cast<std::ptrdiff_t>(i % targets.size()), targets.end());
    sentences.push_back(WriteOne(relation, {group[i]}, targets, i, further));
  }
  return sentences;
}

// One sentence about all; where each of several partners has its share of them, one about each share.
std::vector<v1::Sentence> SentenceWriter::WriteTogether(const hb::Relation& relation, const Group& group,
                                                        const Slots& further) const {
  Group targets;
  if (!FindTargets(relation, *group.front(), targets)) return {};
  const bool one_partner = relation.text().find("{target}") != std::string::npos;
  if (!one_partner || targets.size() < 2 || group.size() < 2 * targets.size()) {
    return {WriteOne(relation, group, targets, 0, further)};
  }
  std::vector<v1::Sentence> sentences;
  std::size_t from = 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const std::size_t to = group.size() * (i + 1) / targets.size();
    sentences.push_back(WriteOne(
        relation,
        Group(group.begin() + static_cast<std::ptrdiff_t>(from), group.begin() + static_cast<std::ptrdiff_t>(to)),
        {targets[i]}, i, further));
    from = to;
  }
  return sentences;
}

v1::Sentence SentenceWriter::WriteOne(const hb::Relation& relation, const Group& subjects, const Group& targets,
                                      std::size_t number, const Slots& further) const {
  const v1::Object& object = *subjects.front();
  const hb::Furniture* furniture = handbook_.FindFurniture(object.name());
  Slots slots = further;
  slots["object"] = SlotOf({&object});
  slots["objects"] = SlotOf(subjects);
  slots["zone"].words = ZoneName(object);
  if (const v1::Zone* zone = ZoneOf(object)) slots["zone"].means = {ZoneWithId(zone->id())};
  slots["corner"].words = CornerOf(object);
  slots["count"].words = kNumbers[std::min(subjects.size(), kNumbers.size() - 1)];
  const bool left = (choice_.Index("side." + object.name(), 2) + number) % 2 == 0;
  slots["side"].words = left ? "left" : "right";
  slots["other_side"].words = left ? "right" : "left";
  // Two benches at one table are at its front and its back.
  const bool front = number / std::max<std::size_t>(targets.size(), 1) % 2 == 0;
  slots["long_side"].words = front ? "front" : "back";
  const bool run_left = choice_.Index("side of the room", 2) == 0;
  slots["room_side"].words = run_left ? "left" : "right";
  slots["other_room_side"].words = run_left ? "right" : "left";
  if (const ProgramItem* line = LineOf(object)) slots["way_m"].words = Metres(line->way_m);
  if (furniture != nullptr) {
    slots["front_m"].words = Metres(furniture->clear_front_m());
    slots["sides_m"].words = Metres(furniture->clear_sides_m());
    slots["back_m"].words = Metres(furniture->clear_back_m());
  }
  if (!targets.empty()) {
    slots["target"] = SlotOf({targets.front()});
    slots["targets"] = SlotOf(targets);
  }
  v1::Sentence sentence;
  sentence.set_text(WithVerb(FillSlots(relation.text(), slots), slots.at("object").words, IsPlural(object.name())));
  sentence.set_reason(FillSlots(relation.reason(), slots));
  sentence.set_weight(relation.weight() > 0 ? relation.weight() : 1);
  for (const v1::Object* subject : subjects) sentence.add_subject_ids(subject->id());
  const bool all = relation.text().find("{targets}") != std::string::npos;
  for (std::size_t i = 0; i < (all ? targets.size() : std::min<std::size_t>(1, targets.size())); ++i) {
    if (!Includes(sentence.subject_ids(), targets[i]->id())) sentence.add_subject_ids(targets[i]->id());
  }
  sentence.set_scope(object.role() == v1::OBJECT_ROLE_TERTIARY ? v1::SENTENCE_SCOPE_TERTIARY
                     : sentence.subject_ids_size() > static_cast<int>(subjects.size()) || subjects.size() > 1
                         ? v1::SENTENCE_SCOPE_INTER
                         : v1::SENTENCE_SCOPE_INTRA);
  if (v1::Meaning meaning = MeaningOf(relation.text(), slots, sentence.text()); meaning.facts_size() > 0) {
    *sentence.mutable_meaning() = std::move(meaning);
  }
  return sentence;
}

Slot SentenceWriter::SlotOf(const Group& group) const {
  Slot slot;
  slot.words = NameOf(group);
  for (const v1::Object* one : group) slot.means.push_back(ObjectWithId(one->id()));
  return slot;
}

namespace {

constexpr std::array<const char*, 12> kOrdinals = {"first",   "second", "third", "fourth", "fifth",    "sixth",
                                                   "seventh", "eighth", "ninth", "tenth",  "eleventh", "twelfth"};

}  // namespace

bool TakesCentre(const v1::ObjectList& objects, const v1::Object& object) {
  constexpr double kFlatM = 0.03;
  if (object.kind() != v1::OBJECT_KIND_SURFACE) return false;
  const auto host = std::ranges::find(objects.objects(), object.host_id(), &v1::Object::id);
  if (host != objects.objects().end() && (host->rim_sides_m() > 0 || host->rim_ends_m() > 0)) return false;
  if (object.height_m() <= kFlatM) return true;
  bool passed = false;
  for (const v1::Object& other : objects.objects()) {
    passed = passed || other.id() == object.id();
    const bool beside = other.kind() == v1::OBJECT_KIND_SURFACE && other.host_id() == object.host_id() &&
                        other.height_m() > kFlatM && other.id() != object.id();
    if (!beside) continue;
    const double area_m2 = object.width_m() * object.depth_m(), other_m2 = other.width_m() * other.depth_m();
    // Two of a kind, such as monitors, stand side by side.
    if (other.name() == object.name() || other_m2 > area_m2 || (other_m2 == area_m2 && !passed)) return false;
    // A lamp in the middle of a small top would leave no corner for the clock.
    const bool fits = host == objects.objects().end() || 2 * other.width_m() + object.width_m() <= host->width_m() ||
                      2 * other.depth_m() + object.depth_m() <= host->depth_m();
    if (!fits) return false;
  }
  return true;
}

std::string SentenceWriter::NameOf(const v1::Object& object) const {
  const std::string& name = spoken_by_id_.at(object.id());
  const std::vector<std::string>& ids = ids_by_spoken_.at(name);
  if (ids.size() == 1) return name;
  const auto at = static_cast<std::size_t>(std::ranges::find(ids, object.id()) - ids.begin());
  return at < kOrdinals.size() ? fmt::format("{} {}", kOrdinals[at], name) : fmt::format("{} {}", name, at + 1);
}

std::string SentenceWriter::NameOf(const Group& group) const {
  if (group.size() == 1) return NameOf(*group.front());
  const std::string& name = spoken_by_id_.at(group.front()->id());
  if (std::ranges::all_of(group, [&](const v1::Object* one) { return spoken_by_id_.at(one->id()) == name; })) {
    return PluralOf(name, handbook_);
  }
  std::vector<std::string> names;
  for (const v1::Object* one : group) names.push_back(NameOf(*one));
  return fmt::format("{} and the {}", fmt::join(names.begin(), names.end() - 1, ", the "), names.back());
}

std::string PluralOf(const std::string& name, const Handbook& handbook) {
  const hb::Furniture* furniture = handbook.FindFurniture(name);
  if (furniture != nullptr && !furniture->plural().empty()) return furniture->plural();
  // A stranger's "dining chairs" are one chair each.
  return english::Plural(english::Singular(name));
}

bool SentenceWriter::IsPlural(const std::string& name) const {
  const hb::Furniture* furniture = handbook_.FindFurniture(name);
  return furniture != nullptr && furniture->plural() == name && name.back() == 's';
}

const v1::Zone* SentenceWriter::ZoneOf(const v1::Object& object) const {
  for (const v1::Zone& zone : zones_.zones()) {
    if (zone.id() == object.zone_id()) return &zone;
  }
  return zones_.zones().empty() ? nullptr : &zones_.zones(0);
}

std::string SentenceWriter::ZoneName(const v1::Object& object) const {
  const v1::Zone* const zone = ZoneOf(object);
  return zone == nullptr ? "main" : zone->name();
}

// Corners of a host's top are taken in turn by what stands on it.
std::string SentenceWriter::CornerOf(const v1::Object& object) const {
  constexpr std::array<const char*, 4> kCorners = {"back left", "back right", "front right", "front left"};
  std::size_t before = 0;
  for (const v1::Object& other : objects_.objects()) {
    if (other.id() == object.id()) break;
    if (other.kind() == v1::OBJECT_KIND_SURFACE && other.host_id() == object.host_id() &&
        !TakesCentre(objects_, other)) {
      ++before;
    }
  }
  return kCorners[before % kCorners.size()];
}

}  // namespace flair::language
