// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/composer.h"

#include <algorithm>

#include "english/words.h"
#include "fmt/format.h"
#include "translator_worker/grammar/translate.h"

namespace flair::translator {
namespace {

// Whether the last word is, or for chairs ends with, one of the words: "desk chair", "armchairs", but not "workbench".
bool EndsWithOneOf(const std::string& name, std::initializer_list<const char*> ends) {
  const size_t space = name.find_last_of(" _");
  const std::string last = english::Singular(space == std::string::npos ? name : name.substr(space + 1));
  return std::any_of(ends.begin(), ends.end(), [&](const std::string& end) {
    return last == end || (end == "chair" && last.size() > 5 && last.substr(last.size() - 5) == end);
  });
}

// "bed 1", "bed1".
std::string WithoutNumber(std::string name) {
  while (!name.empty() && (name.back() == ' ' || name.back() == '_' || (name.back() >= '0' && name.back() <= '9')))
    name.pop_back();
  return name;
}

}  // namespace

Composer::Composer(const v1::TranslateRequest& request, const SceneNames& names, const CatalogIndex& catalog,
                   const v1::Sentence& sentence)
    : request_(request), names_(names), catalog_(catalog), sentence_(sentence) {
  for (const std::string& subject : sentence.subject_ids()) {
    for (int i = 0; i < request.object_list().objects_size(); ++i) {
      if (object(i).id() == subject) subjects_.push_back({i, ""});
    }
  }
  // A bare distance in a sentence about two things, or two kinds of them, is kept between them.
  std::vector<Placed> others;
  for (const Placed& placed : subjects_) {
    if (object(placed.object).name() != object(subjects_.front().object).name()) others.push_back(placed);
  }
  const bool two_kinds = !others.empty() && std::all_of(others.begin(), others.end(), [&](const Placed& other) {
    return object(other.object).name() == object(others.front().object).name();
  });
  const bool two = subjects_.size() == 2;
  if (sentence.scope() == v1::SENTENCE_SCOPE_INTER && (two || two_kinds)) {
    std::vector<Placed> first = two ? std::vector<Placed>{subjects_[0]} : subjects_;
    if (!two)
      std::erase_if(first,
                    [&](const Placed& one) { return object(one.object).name() == object(others[0].object).name(); });
    SetPair(std::move(first), two ? std::vector<Placed>{subjects_[1]} : others);
  }
  // Of a heading that names several kinds of things the first is what moves.
  for (const Placed& placed : subjects_) {
    if (object(placed.object).name() == object(subjects_.front().object).name()) topic_.push_back(placed);
  }
}

bool Composer::IsChair(const Placed& placed) const {
  return EndsWithOneOf(object(placed.object).name(), {"chair", "stool", "bench", "throne", "seat"});
}

bool Composer::StandsAtSubject(const Placed& chair) const {
  return scope() == v1::SENTENCE_SCOPE_INTRA && subjects_.size() == 1 && IsChair(chair) &&
         !IsChair(subjects_.front()) && chair.object != subjects_.front().object;
}

bool Composer::IsSeat(const Placed& placed) const {
  return EndsWithOneOf(object(placed.object).name(),
                       {"chair", "sofa", "couch", "stool", "bench", "loveseat", "recliner", "sectional", "settee",
                        "banquette", "pew", "throne", "seat"});
}

bool Composer::IsTable(const Placed& placed) const {
  return EndsWithOneOf(WithoutNumber(object(placed.object).name()),
                       {"table", "desk", "counter", "island", "workbench"});
}

bool Composer::IsHot(const Placed& placed) const {
  return EndsWithOneOf(object(placed.object).name(), {"stove", "oven", "cooker", "fireplace", "hearth", "range"});
}

bool Composer::IsBed(const Placed& placed) const {
  return EndsWithOneOf(WithoutNumber(object(placed.object).name()),
                       {"bed", "daybed", "cot", "crib", "coffin", "bathtub", "hammock", "bunk", "futon", "mattress"});
}

bool Composer::IsWalkIn(const Placed& placed) const {
  return EndsWithOneOf(object(placed.object).name(), {"shower", "cubicle", "enclosure", "cabin", "tent", "sauna"});
}

bool Composer::HasDoors(const Placed& placed) const {
  return IsWalkIn(placed) ||
         EndsWithOneOf(object(placed.object).name(),
                       {"wardrobe", "cabinet", "cupboard", "closet",  "armoire", "locker", "sideboard",  "refrigerator",
                        "fridge",   "oven",    "pantry",   "hutch",   "dresser", "drawer", "nightstand", "dishwasher",
                        "washer",   "dryer",   "cooler",   "freezer", "kiln",    "safe",   "case",       "booth"});
}

bool Composer::HasFeature(const std::string& kind) const {
  if (kind == "socket") return request_.room().sockets_size() > 0;
  const auto wanted = kind == "door" ? v1::OPENING_KIND_DOOR : v1::OPENING_KIND_WINDOW;
  return std::any_of(request_.room().openings().begin(), request_.room().openings().end(),
                     [&](const v1::Opening& opening) { return opening.kind() == wanted; });
}

void Composer::SetPair(std::vector<Placed> movers, std::vector<Placed> targets) {
  pair_movers_ = std::move(movers);
  pair_targets_ = std::move(targets);
}

void Composer::SetTopic(std::vector<Placed> topic) {
  if (topic.empty() || topic_.empty() || topic.front().object != topic_.front().object) earlier_topic_ = topic_;
  topic_ = std::move(topic);
}

v1::Diagnostic Composer::Remark(v1::Severity severity, std::string_view code, const std::string& message) const {
  v1::Diagnostic remark;
  remark.set_severity(severity);
  remark.set_code(std::string(code));
  remark.set_message(fmt::format("\"{}\": {}", Quote(sentence_.text()), message));
  remark.set_subject_id(sentence_.id());
  return remark;
}

void Composer::Refuse(std::string_view code, const std::string& message) {
  v1::Diagnostic remark = Remark(v1::SEVERITY_WARNING, code, message);
  const bool known = std::any_of(refusals_.begin(), refusals_.end(),
                                 [&](const v1::Diagnostic& other) { return other.message() == remark.message(); });
  if (!known) refusals_.push_back(std::move(remark));
}

bool Composer::OnlyUnknown() const {
  return std::all_of(refusals_.begin(), refusals_.end(),
                     [](const v1::Diagnostic& refusal) { return refusal.code() == "unknown_sentence"; });
}

void Composer::Note(std::string_view code, const std::string& message) {
  notes_.push_back(Remark(v1::SEVERITY_NOTE, code, message));
}

}  // namespace flair::translator
