// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/completion/complete_constraints.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "language_worker/handbook/parts/furniture_index.h"
#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/sentences/list_constraints.h"

namespace flair::language {
namespace {

// Whether the object is carried as the class is: a "reading lamp" on a desk is no floor lamp.
bool IsCarriedAlike(const v1::Object& object, const hb::Furniture& furniture) {
  const int kind = furniture.kind() == hb::FURNITURE_KIND_UNSPECIFIED ? hb::FURNITURE_KIND_FLOOR : furniture.kind();
  return static_cast<int>(object.kind()) == kind;
}

// Whether the class is used with one of these.
bool HasPartner(const hb::Furniture& furniture, const std::set<std::string>& classes) {
  return std::ranges::any_of(furniture.relations(), [&](const hb::Relation& relation) {
    return relation.use() &&
           std::ranges::any_of(relation.targets(), [&](const std::string& target) { return classes.contains(target); });
  });
}

// A plain "chair" is what its room needs: the dining chair that it is called after, but an office chair where there is
// a desk and no dining table. Null when the class has its partner, or no class of its category has one.
const hb::Furniture* UsedInstead(const hb::Furniture& furniture, const std::set<std::string>& classes,
                                 const Handbook& handbook) {
  if (HasPartner(furniture, classes)) return nullptr;
  const auto found = std::ranges::find_if(handbook.contents().furniture(), [&](const hb::Furniture& other) {
    return other.category() == furniture.category() && other.kind() == furniture.kind() && HasPartner(other, classes);
  });
  return found == handbook.contents().furniture().end() ? nullptr : &*found;
}

// The objects by the names of their classes; those of no class keep their own.
v1::ObjectList ByClass(const v1::ObjectList& objects, const Handbook& handbook) {
  const FurnitureIndex index(handbook);
  v1::ObjectList named = objects;
  std::set<std::string> classes;
  for (v1::Object& object : *named.mutable_objects()) {
    const hb::Furniture* furniture = index.Find(object.name());
    if (furniture == nullptr || !IsCarriedAlike(object, *furniture)) continue;
    object.set_name(furniture->name());
    object.set_category(furniture->category());
    classes.insert(furniture->name());
  }
  for (int i = 0; i < objects.objects_size(); ++i) {
    v1::Object& object = *named.mutable_objects(i);
    // Who calls it by the class's own name means that class.
    if (!classes.contains(object.name()) || PlainName(objects.objects(i).name()) == object.name()) continue;
    const hb::Furniture* instead = UsedInstead(*handbook.FindFurniture(object.name()), classes, handbook);
    if (instead != nullptr) object.set_name(instead->name());
  }
  return named;
}

class Completion {
 public:
  Completion(const v1::Brief& brief, const v1::ObjectList& objects, const v1::ConstraintList& list) : list_(list) {
    for (const v1::Sentence& sentence : brief.constraint_list().sentences()) brief_ids_.insert(sentence.id());
    for (const v1::Object& object : objects.objects()) {
      if (object.role() == v1::OBJECT_ROLE_TERTIARY) tertiary_ids_.insert(object.id());
    }
    for (const v1::Sentence& sentence : list.sentences()) {
      if (sentence.subject_ids_size() > 0) placed_ids_.insert(sentence.subject_ids(0));
    }
  }

  void Add(const UseSentence& use) {
    const v1::Sentence& sentence = use.sentence;
    if (MarkSaid(sentence)) return;
    // [Paper] One constraint per tertiary object: where somebody has placed it, there it stays.
    const std::string& mover = sentence.subject_ids(0);
    if (tertiary_ids_.contains(mover) && placed_ids_.contains(mover)) return;
    Overrule(use);
    v1::Sentence& added = implied_.emplace_back(sentence);
    added.set_origin(v1::SENTENCE_ORIGIN_IMPLIED);
    added.set_use(true);
    added.set_id(NextId());
    added.set_reason(fmt::format("nobody asked for it: {}",
                                 sentence.reason().empty() ? "it is how one uses it" : sentence.reason()));
  }

  v1::ConstraintList Take() && {
    for (v1::Sentence& sentence : implied_) *list_.add_sentences() = std::move(sentence);
    // In the order of the translation's passes.
    std::stable_sort(list_.mutable_sentences()->begin(), list_.mutable_sentences()->end(),
                     [](const v1::Sentence& a, const v1::Sentence& b) { return a.scope() < b.scope(); });
    return std::move(list_);
  }

 private:
  // Whether somebody says just that already; then it is known for a use from here on.
  bool MarkSaid(const v1::Sentence& use) {
    const std::string text = PlainName(use.text());
    const auto same = [&](const v1::Sentence& other) { return PlainName(other.text()) == text; };
    if (std::ranges::any_of(implied_, same)) return true;
    const auto said = std::ranges::find_if(*list_.mutable_sentences(), same);
    if (said == list_.mutable_sentences()->end()) return false;
    said->set_use(true);
    return true;
  }

  // Takes out what others wish of the pieces that the use moves, of these alone.
  void Overrule(const UseSentence& use) {
    const std::set<std::string> used(use.sentence.subject_ids().begin(), use.sentence.subject_ids().end());
    const auto gives_way = [&](const v1::Sentence& other) {
      if (IsOfBrief(other) || other.scope() == v1::SENTENCE_SCOPE_TERTIARY) return false;
      if (other.subject_ids().empty() || other.subject_ids(0) != use.sentence.subject_ids(0)) return false;
      const bool alone = std::ranges::all_of(other.subject_ids(), [&](const auto& id) { return used.contains(id); });
      const std::string words = fmt::format(" {} ", PlainName(other.text()));
      return alone && std::ranges::any_of(use.overrules, [&](const std::string& word) {
               return words.find(fmt::format(" {} ", word)) != std::string::npos;
             });
    };
    auto& sentences = *list_.mutable_sentences();
    for (int i = 0; i < sentences.size();) {
      if (!gives_way(sentences[i])) {
        ++i;
        continue;
      }
      v1::CleaningStep& step = *list_.add_cleaning_steps();
      step.set_action(v1::CLEANING_ACTION_USE_FIRST);
      step.add_from_ids(sentences[i].id());
      step.set_reason(fmt::format("\"{}\" gives way to \"{}\"", sentences[i].text(), use.sentence.text()));
      sentences.DeleteSubrange(i, 1);
    }
  }

  // Whether the user says so, also where cleaning has put it into other words.
  bool IsOfBrief(const v1::Sentence& sentence) const {
    return sentence.origin() == v1::SENTENCE_ORIGIN_BRIEF || brief_ids_.contains(sentence.id()) ||
           std::ranges::any_of(sentence.made_from_ids(), [&](const auto& id) { return brief_ids_.contains(id); });
  }

  std::string NextId() {
    const auto is_taken = [&](const std::string& id) {
      return std::ranges::any_of(list_.sentences(), [&](const v1::Sentence& one) { return one.id() == id; });
    };
    std::string id;
    do id = fmt::format("u{}", ++last_number_);
    while (is_taken(id));
    return id;
  }

  v1::ConstraintList list_;
  std::set<std::string> brief_ids_;
  std::set<std::string> tertiary_ids_;
  std::set<std::string> placed_ids_;
  std::vector<v1::Sentence> implied_;
  int last_number_ = 0;
};

}  // namespace

v1::ConstraintList CompleteConstraints(const ObjectsRequest& request, const v1::ObjectList& objects,
                                       const v1::ConstraintList& list, const Handbook& handbook) {
  const absl::StatusOr<BriefFacts> facts = ReadBrief(request.brief, handbook);
  const Handbook& all = facts.ok() ? facts->HandbookOr(handbook) : handbook;
  const absl::StatusOr<std::vector<UseSentence>> uses =
      ListUses(request.brief, request.room, request.zones, ByClass(objects, all), objects, handbook);
  if (!uses.ok()) {
    v1::ConstraintList same = list;
    AddDiagnostic(v1::SEVERITY_NOTE, "not_completed",
                  fmt::format("Nothing was added of how one uses the pieces: {}", std::string(uses.status().message())),
                  same);
    return same;
  }
  Completion completion(request.brief, objects, list);
  for (const UseSentence& use : *uses) completion.Add(use);
  return std::move(completion).Take();
}

}  // namespace flair::language
