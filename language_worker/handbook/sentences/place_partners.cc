// SPDX-License-Identifier: GPL-3.0-or-later
// Which pieces go with those of a place: what stands there for them, what they hang by, what they are between.
#include <string>

#include "language_worker/handbook/sentences/place_writer.h"

namespace flair::language {

// What hangs on a wall belongs to no other piece, but for what the brief says.
std::vector<v1::Sentence> PlaceWriter::WriteHung(const hb::Relation& relation, const Place& place, const Group& group,
                                                 const Slots& further) const {
  std::vector<v1::Sentence> sentences;
  if (group.front()->kind() != v1::OBJECT_KIND_WALL || relation.pairing() == hb::PAIRING_TOGETHER) return sentences;
  for (const v1::Object* object : group) {
    const v1::Object* target = Neighbour(*place.target, *object, nullptr);
    if (target != nullptr)
      sentences.push_back(writer_.WriteOne(relation, {object}, {target}, sentences.size(), further));
  }
  return sentences;
}

Group PlaceWriter::WhatGoesThere(const Group& group) const {
  const auto as_many = [&](const std::string& name) {
    const auto found = writer_.groups().find(name);
    return found != writer_.groups().end() && found->second.size() == group.size() ? found->second : Group();
  };
  for (const ProgramItem& item : program_.tertiary_items) {
    if (item.furniture->name() != group.front()->name() || item.entry == nullptr || !item.entry->per_host()) continue;
    for (const std::string& host : item.entry->hosts()) {
      if (const Group hosts = as_many(host); !hosts.empty()) return hosts;
    }
  }
  for (const hb::Relation& relation : program_.archetype->relations()) {
    if (relation.object() != group.front()->name() ||
        relation.text().find("in front of the {target}") == std::string::npos)
      continue;
    for (const std::string& name : relation.targets()) {
      if (const Group faced = as_many(name); !faced.empty()) return faced;
    }
  }
  return group;
}

std::vector<v1::Sentence> PlaceWriter::WriteBetween(const Place& place, const Group& group) const {
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

const v1::Object* PlaceWriter::Neighbour(const hb::Furniture& furniture, const v1::Object& object,
                                         const v1::Object* other) const {
  const v1::Object* best = nullptr;
  for (const std::string& name : WithSubstitutes(std::array{furniture.name()}, program_)) {
    const auto found = writer_.groups().find(name);
    if (found == writer_.groups().end()) continue;
    for (const v1::Object* one : found->second) {
      if (one == &object || one == other) continue;
      if (best == nullptr || (best->zone_id() != object.zone_id() && one->zone_id() == object.zone_id())) best = one;
    }
  }
  return best;
}

}  // namespace flair::language
