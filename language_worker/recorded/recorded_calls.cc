// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "english/language.h"
#include "language_worker/model/model_tools.h"
#include "language_worker/recorded/import_answers.h"
#include "language_worker/recorded/recorded_text.h"

namespace flair::language {
namespace {

using KeySet = std::set<std::string, std::less<>>;

// A recorded call in today's words.
struct RecordedCall {
  std::string function;
  // As an answer writes it, "near(object=sofa, target=shelf, max_distance_m=1)".
  std::string text;
  std::vector<std::string> objects;
  // Doors, zones, distances: what else the sentence should name.
  std::vector<std::string> words;
};

// Today's ids of the recorded objects, by theirs; empty for those that are not there any more.
using Ids = std::map<std::string, std::string>;

Ids IdsOf(const RecordedRoom& room, const std::vector<PromptObjects>& listed) {
  std::vector<const v1::Object*> objects;
  for (const v1::Object& object : room.graph.object_list().objects()) objects.push_back(&object);
  const PromptIds prompt_ids(objects, listed, /*loosely=*/true);
  Ids ids;
  for (size_t i = 0; i < objects.size(); ++i) ids[objects[i]->id()] = prompt_ids.IdOf(i);
  return ids;
}

std::vector<std::string> ValuesOf(const v1::ArgumentValue& value) {
  switch (value.value_case()) {
    case v1::ArgumentValue::kTexts:
      return {value.texts().items().begin(), value.texts().items().end()};
    case v1::ArgumentValue::kNumber:
      return {fmt::format("{}", value.number())};
    case v1::ArgumentValue::kFlag:
      return {value.flag() ? "true" : "false"};
    default:
      return {value.text()};
  }
}

// False when the call names an object that is not there any more.
bool ReadCall(const v1::ConstraintEdge& edge, const Ids& ids, RecordedCall& call) {
  call.function = edge.type();
  bool there = true;
  std::vector<std::string> arguments;
  for (const v1::Argument& argument : edge.arguments()) {
    std::vector<std::string> values = ValuesOf(argument.value());
    for (std::string& value : values) {
      const auto object = ids.find(value);
      if (object != ids.end()) {
        there = there && !object->second.empty();
        if (!object->second.empty()) value = object->second;
      }
      (object != ids.end() ? call.objects : call.words).push_back(value);
    }
    const std::string list = fmt::format("{}", fmt::join(values, ", "));
    arguments.push_back(argument.name() + "=" + (values.size() == 1 ? list : "[" + list + "]"));
  }
  call.text = fmt::format("{}({})", edge.type(), fmt::join(arguments, ", "));
  return there;
}

// Whether a sentence of these words, lower case and singular, names the feature that a value is; other values need not
// be named.
bool NamesFeature(const std::string& value, const KeySet& words) {
  if (value != "door" && value != "window" && value != "socket") return true;
  return std::ranges::any_of(words,
                             [&](const std::string& word) { return english::Language::Get().IsIn(value + "s", word); });
}

class CallMatcher {
 public:
  // `items`: the sentences are about items, one each.
  CallMatcher(const std::vector<PromptSentence>& sentences, const std::vector<PromptObjects>& objects, bool items)
      : sentences_(sentences), items_(items) {
    for (const PromptObjects& equal : objects) {
      for (const std::string& id : equal.ids) names_[id] = NameKey(equal.name);
    }
    for (const PromptSentence& sentence : sentences) {
      KeySet words;
      for (Word& word : ReadWords(sentence.text)) words.insert(std::move(word.key));
      words_.push_back(std::move(words));
      model::v1::SentenceCallsAnswer& entry = *answer_.add_sentences();
      entry.set_id(sentence.id);
    }
  }

  // Whether a sentence, one that has the word if one is given, takes it.
  bool Give(const RecordedCall& call, const std::string& word) {
    int best = -1;
    double best_score = 0;
    for (size_t i = 0; i < sentences_.size(); ++i) {
      if (!word.empty() && !words_[i].contains(word)) continue;
      // Of equal ones that with fewer calls.
      const double score = Score(call, i) - 0.1 * answer_.sentences(static_cast<int>(i)).calls_size();
      if (score <= best_score) continue;
      best = static_cast<int>(i);
      best_score = score;
    }
    if (best < 0) return false;
    answer_.mutable_sentences(best)->add_calls(call.text);
    return true;
  }

  model::v1::CallsAnswer Finish() {
    for (model::v1::SentenceCallsAnswer& entry : *answer_.mutable_sentences()) {
      if (entry.calls().empty()) entry.add_calls("none(not recorded)");
    }
    return std::move(answer_);
  }

 private:
  // Whether the sentence is about the object, or names it.
  bool Names(size_t i, const std::string& object) const {
    const auto& subjects = sentences_[i].subject_ids;
    if (std::ranges::find(subjects, object) != subjects.end()) return true;
    const auto name = names_.find(object);
    if (name == names_.end()) return false;
    const std::vector<Word> words = ReadWords(sentences_[i].text);
    for (size_t begin = 0; begin < words.size(); ++begin) {
      std::string key;
      for (size_t k = begin; k < words.size() && key.size() < name->second.size(); ++k) key += words[k].key;
      if (key == name->second) return true;
    }
    return false;
  }

  double Score(const RecordedCall& call, size_t i) const {
    for (const std::string& object : call.objects) {
      if (!Names(i, object)) return 0;
    }
    if (call.objects.empty()) return 0;
    const std::string list = "says " + call.function;
    const auto says = [&](const std::string& word) { return english::Language::Get().IsIn(list, word); };
    double score = static_cast<double>(std::ranges::count_if(words_[i], says));
    // An item's sentence is the only one about it, in whatever words.
    const auto& subjects = sentences_[i].subject_ids;
    const bool first = !subjects.empty() && subjects.front() == call.objects.front();
    if (score == 0 && !(items_ && first)) return 0;
    score += 0.5;
    for (const std::string& value : call.words) {
      for (const Word& word : ReadWords(value)) {
        if (words_[i].contains(word.key) || words_[i].contains(word.key + "m")) score += 3;
      }
    }
    // A feature that the sentence does not name is not what it is about.
    for (const std::string& value : call.words) {
      if (!NamesFeature(value, words_[i])) return 0;
    }
    return score + (first ? 0.5 : 0);
  }

  const std::vector<PromptSentence>& sentences_;
  const bool items_;
  std::map<std::string, std::string> names_;
  std::vector<KeySet> words_;
  model::v1::CallsAnswer answer_;
};

bool IsOfAWall(std::string_view type) { return type == "against_wall" || type == "near_wall" || type == "in_corner"; }

// Which of the three passes a call is for, by its objects: items, several, or one. Rugs are items, whatever they were
// listed with.
enum class CallKind { kIntra, kInter, kTertiary };

CallKind KindOf(const v1::ConstraintEdge& edge, const RecordedRoom& room) {
  KeySet items, pieces;
  for (const v1::Object& object : room.graph.object_list().objects()) {
    const bool item = object.role() == v1::OBJECT_ROLE_TERTIARY || IsRugName(object.name());
    (item ? items : pieces).insert(object.id());
  }
  int count = 0;
  for (const v1::Argument& argument : edge.arguments()) {
    for (const std::string& value : ValuesOf(argument.value())) {
      if (items.contains(value)) return CallKind::kTertiary;
      count += pieces.contains(value) ? 1 : 0;
    }
  }
  return count > 1 ? CallKind::kInter : CallKind::kIntra;
}

}  // namespace

model::v1::CallsAnswer FindCalls(const RecordedRoom& room, std::string_view step, std::string_view prompt,
                                 Conversion& conversion) {
  const std::vector<PromptObjects> objects = ReadPromptObjects(prompt);
  const std::vector<PromptSentence> sentences = ReadPromptSentences(prompt);
  const CallKind kind = step.ends_with("tertiary") ? CallKind::kTertiary
                        : step.ends_with("inter")  ? CallKind::kInter
                                                   : CallKind::kIntra;
  const Ids ids = IdsOf(room, objects);
  CallMatcher matcher(sentences, objects, kind == CallKind::kTertiary);
  for (const v1::ConstraintEdge& edge : room.graph.edges()) {
    const bool own = KindOf(edge, room) == kind;
    const bool known = prompt.find(fmt::format("\n- {}(", edge.type())) != std::string_view::npos;
    RecordedCall call;
    const bool there = ReadCall(edge, ids, call);
    // A sentence about a pair may say of one of them where its wall is.
    const bool taken = known && there && (own || (kind == CallKind::kInter && IsOfAWall(edge.type())));
    if (taken && matcher.Give(call, own ? "" : "wall")) {
      if (own) conversion.Convert();
      continue;
    }
    if (!own) continue;
    conversion.Keep("calls", 0, call.text,
                    !there  ? "its object was left out"
                    : known ? "no sentence says it"
                            : "is for another pass");
  }
  return matcher.Finish();
}

}  // namespace flair::language
