// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/sentences/sentence_slots.h"

#include <google/protobuf/repeated_ptr_field.h>

#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "english/frames/facts.h"
#include "language_worker/handbook/sentences/fill.h"
#include "worker_runtime/files/files.h"

namespace flair::language {
namespace {

using Participants = google::protobuf::RepeatedPtrField<v1::Participant>;

// What slots are called in a template that is read for its meaning: no word of any language.
constexpr std::string_view kMark = "slotnamed";

// The slots that mean something, as names.
class SlotNames : public english::Names {
 public:
  explicit SlotNames(const Slots& slots) : slots_(slots) {}

  Found Find(const std::vector<english::Token>& tokens, size_t at) const override {
    Found found;
    const std::string& word = tokens[at].text;
    if (!word.starts_with(kMark)) return found;
    const auto slot = slots_.find(std::string_view(word).substr(kMark.size()));
    if (slot == slots_.end() || slot->second.means.empty()) return found;
    const v1::Participant& first = slot->second.means.front();
    found.length = 1;
    found.full = true;
    found.reference.name = slot->first;
    found.reference.full = true;
    found.reference.plural = slot->first.ends_with('s');
    found.reference.kind = first.has_object_id() ? english::RefKind::kObjects
                           : first.has_zone_id() ? english::RefKind::kZone
                                                 : english::RefKind::kWall;
    return found;
  }

 private:
  const Slots& slots_;
};

// Adds what a noun phrase refers to.
void AddTo(Participants& participants, const std::optional<english::Mention>& mention, const Slots& slots) {
  if (!mention) return;
  for (const english::Reference& reference : mention->references) {
    const v1::ParticipantSide side = english::SideOf(reference.side).value_or(v1::PARTICIPANT_SIDE_UNSPECIFIED);
    const auto slot = slots.find(reference.name);
    std::vector<v1::Participant> meant;
    if (slot != slots.end()) meant = slot->second.means;
    if (slot == slots.end()) meant.emplace_back().set_part(*english::PartOf(reference));
    for (v1::Participant& one : meant) {
      one.set_side(side);
      *participants.Add() = std::move(one);
    }
  }
}

using KnownFacts = std::shared_ptr<const std::optional<std::vector<english::Fact>>>;

// The facts of a template, each read once: a handbook has some hundred. Any thread.
KnownFacts FactsOfTemplate(const std::string& readable, const Slots& slots) {
  constexpr std::size_t kMostKept = 2000;
  static std::mutex mutex;
  static auto& kept = *new std::map<std::string, KnownFacts>;
  {
    const std::lock_guard lock(mutex);
    if (const auto known = kept.find(readable); known != kept.end()) return known->second;
  }
  auto read =
      std::make_shared<const std::optional<std::vector<english::Fact>>>(english::ReadFacts(readable, SlotNames(slots)));
  const std::lock_guard lock(mutex);
  if (kept.size() >= kMostKept) kept.clear();
  kept[readable] = read;
  return read;
}

std::string ReadableTemplate(std::string_view sentence_template, const Slots& slots) {
  std::map<std::string, std::string, std::less<>> words;
  for (const auto& [name, slot] : slots) words[name] = slot.means.empty() ? slot.words : std::string(kMark) + name;
  return Fill(sentence_template, words);
}

}  // namespace

v1::Participant ObjectWithId(const std::string& id) {
  v1::Participant participant;
  participant.set_object_id(id);
  return participant;
}

v1::Participant ZoneWithId(const std::string& id) {
  v1::Participant participant;
  participant.set_zone_id(id);
  return participant;
}

std::string FillSlots(std::string_view sentence_template, const Slots& slots) {
  std::map<std::string, std::string, std::less<>> words;
  for (const auto& [name, slot] : slots) words[name] = slot.words;
  return Fill(sentence_template, words);
}

v1::Meaning MeaningOf(std::string_view sentence_template, const Slots& slots, std::string_view text) {
  v1::Meaning meaning;
  const KnownFacts facts = FactsOfTemplate(ReadableTemplate(sentence_template, slots), slots);
  if (!facts->has_value()) return meaning;
  meaning.set_text_digest(runtime::Sha256Hex(text));
  for (const english::Fact& fact : **facts) {
    v1::Fact& message = *meaning.add_facts();
    message.set_relation(fact.meaning);
    message.set_detail(fact.detail);
    AddTo(*message.mutable_movers(), fact.a, slots);
    AddTo(*message.mutable_targets(), fact.b, slots);
    AddTo(*message.mutable_others(), fact.c, slots);
    if (!fact.distance) continue;
    v1::Measure& measure = *message.mutable_measure();
    if (fact.distance->min_m) measure.set_min_m(*fact.distance->min_m);
    if (fact.distance->max_m) measure.set_max_m(*fact.distance->max_m);
    measure.set_exact(fact.distance->exact);
  }
  return meaning;
}

}  // namespace flair::language
