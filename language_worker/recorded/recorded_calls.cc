// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/recorded_calls.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "language_worker/model/furniture_index.h"
#include "language_worker/recorded/object_names.h"
#include "language_worker/recorded/prompt_lines.h"

namespace flair::language {
namespace {

using KeySet = std::set<std::string, std::less<>>;

// Words, singular, by which a sentence says what a function does.
const std::map<std::string, KeySet, std::less<>> kWordsOf = {
    {"accessible",
     {"access", "accessible", "accessibility", "reach", "clear", "clearance", "space", "free", "open", "room"}},
    {"against_wall", {"wall", "against", "back"}},
    {"away_from", {"away", "distance", "apart", "least", "minimum", "gap", "separate", "clearance", "not"}},
    {"away_from_feature", {"away", "avoid", "near", "not", "distance"}},
    {"between", {"between"}},
    {"ceiling_above", {"ceiling", "above", "over", "hang", "hung"}},
    {"ceiling_center", {"ceiling", "center", "centre", "central", "centrally", "middle"}},
    {"central", {"center", "centre", "central", "centrally", "middle", "centered"}},
    {"centered_on_wall", {"center", "centre", "centered", "wall"}},
    {"clear_of_feature", {"block", "obstruct", "avoid", "clear", "interfere", "front", "not"}},
    {"close_to_feature", {"near", "close", "access", "proximity", "next", "by", "under"}},
    {"facing", {"face", "facing", "opposite", "view", "toward"}},
    {"facing_into_room", {"face", "facing", "view", "room", "into", "center"}},
    {"in_corner", {"corner"}},
    {"in_front_of", {"front", "before"}},
    {"in_zone", {"area", "zone", "region", "within"}},
    {"near", {"near", "close", "within", "reach", "easy", "access", "proximity", "adjacent", "most", "beside"}},
    {"near_wall", {"wall", "near", "along", "against", "back"}},
    {"next_to", {"next", "beside", "side", "against", "adjacent", "left", "right", "flush", "foot"}},
    {"not_against_wall", {"wall", "away", "not", "distance"}},
    {"not_facing", {"face", "facing", "not"}},
    {"on_top_center", {"on", "top", "center", "atop"}},
    {"on_top_corner", {"corner", "edge", "side", "end"}},
    {"on_wall_above", {"above", "over", "wall", "behind"}},
    {"on_wall_in_zone", {"wall", "area"}},
    {"on_wall_near", {"near", "wall", "next", "by"}},
    {"parallel", {"parallel", "align", "aligned", "same", "direction"}},
    {"perpendicular", {"perpendicular", "angle"}},
    {"rug_under_center", {"under", "beneath", "center"}},
    {"rug_under_forward", {"under", "front", "beneath", "partially"}},
    {"surround", {"around", "surround", "surrounded", "each", "side"}},
    {"under_window", {"under", "window", "below"}}};

// A recorded call in today's words.
struct RecordedCall {
  std::string function;
  // As an answer writes it.
  std::string text;
  std::vector<std::string> objects;
  // Doors, zones, distances: what else the sentence should name.
  std::vector<std::string> words;
};

// Today's ids of the recorded objects.
class Ids {
 public:
  Ids(const RecordedRoom& room, const std::vector<PromptObject>& listed) {
    std::vector<bool> used(listed.size(), false);
    // Of equal names first those of equal size: sizes may have been mended.
    for (const bool exact : {true, false}) {
      for (const v1::Object& object : room.graph.object_list().objects()) {
        if (ids_.contains(object.id())) continue;
        for (size_t i = 0; i < listed.size(); ++i) {
          const PromptObject& other = listed[i];
          if (used[i] || NameKey(other.name) != NameKey(object.name())) continue;
          const auto near = [](double a, double b) { return a - b < 0.006 && b - a < 0.006; };
          const bool tertiary = object.role() == v1::OBJECT_ROLE_TERTIARY;
          if (exact && !(near(other.width_m, object.width_m()) && near(other.depth_m, object.depth_m()) &&
                         (tertiary || other.zone_id == object.zone_id()))) {
            continue;
          }
          ids_[object.id()] = other.id;
          used[i] = true;
          break;
        }
      }
    }
    for (const v1::Object& object : room.graph.object_list().objects()) recorded_.insert(object.id());
  }

  // False when the value is an object that is not there any more.
  bool Translate(std::string& value, bool& is_object) const {
    is_object = recorded_.contains(value);
    if (!is_object) return true;
    const auto found = ids_.find(value);
    if (found == ids_.end()) return false;
    value = found->second;
    return true;
  }

 private:
  std::map<std::string, std::string> ids_;
  KeySet recorded_;
};

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

// "near(sofa, shelf, max_distance_m=1)": what the function needs by its place, the rest by name.
std::string CallText(const std::string& function, const std::vector<std::string>& needed,
                     const std::vector<std::pair<std::string, std::vector<std::string>>>& arguments) {
  std::vector<std::string> by_place(needed.size()), written;
  for (const auto& [name, values] : arguments) {
    const std::string value = values.size() == 1 ? values.front() : fmt::format("[{}]", fmt::join(values, ", "));
    const auto place = std::find(needed.begin(), needed.end(), name);
    if (place != needed.end()) {
      by_place[static_cast<size_t>(place - needed.begin())] = value;
    } else {
      written.push_back(fmt::format("{}={}", name, value));
    }
  }
  // Without one of them the others are told by name.
  const bool all = std::find(by_place.begin(), by_place.end(), "") == by_place.end();
  for (size_t i = by_place.size(); i-- > 0;) {
    if (by_place[i].empty()) continue;
    written.insert(written.begin(), all ? by_place[i] : fmt::format("{}={}", needed[i], by_place[i]));
  }
  return fmt::format("{}({})", function, fmt::join(written, ", "));
}

// False when the call names an object that is not there any more.
bool ReadCall(const v1::ConstraintEdge& edge, const std::vector<std::string>& needed, const Ids& ids,
              RecordedCall& call) {
  call.function = edge.type();
  bool there = true;
  std::vector<std::pair<std::string, std::vector<std::string>>> arguments;
  for (const v1::Argument& argument : edge.arguments()) {
    std::vector<std::string> values = ValuesOf(argument.value());
    for (std::string& value : values) {
      bool is_object = false;
      there = ids.Translate(value, is_object) && there;
      (is_object ? call.objects : call.words).push_back(value);
    }
    arguments.emplace_back(argument.name(), std::move(values));
  }
  call.text = CallText(edge.type(), needed, arguments);
  return there;
}

class CallMatcher {
 public:
  // `items`: the sentences are about items, one each.
  CallMatcher(const std::vector<PromptSentence>& sentences, const std::vector<PromptObject>& objects, bool items)
      : sentences_(sentences), items_(items) {
    for (const PromptObject& object : objects) names_[object.id] = NameKey(object.name);
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
    if (std::find(subjects.begin(), subjects.end(), object) != subjects.end()) return true;
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
    const auto known = kWordsOf.find(call.function);
    if (call.objects.empty() || known == kWordsOf.end()) return 0;
    double score = 0;
    for (const std::string& word : known->second) score += words_[i].contains(word) ? 1 : 0;
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
    static const KeySet kFeatures = {"door", "window", "socket"};
    for (const std::string& value : call.words) {
      if (!kFeatures.contains(value)) continue;
      const bool outlet = value == "socket" && (words_[i].contains("outlet") || words_[i].contains("power"));
      const bool entry = value == "door" && (words_[i].contains("doorway") || words_[i].contains("entrance") ||
                                             words_[i].contains("entry") || words_[i].contains("entryway"));
      if (!words_[i].contains(value) && !outlet && !entry) return 0;
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
  std::map<std::string, std::vector<std::string>> functions;  // with what they need
  for (PromptFunction& function : ReadPromptFunctions(prompt)) functions[function.name] = std::move(function.needed);
  const std::vector<PromptObject> objects = ReadTranslationObjects(prompt);
  const std::vector<PromptSentence> sentences = ReadPromptSentences(prompt);
  const CallKind kind = step.ends_with("tertiary") ? CallKind::kTertiary
                        : step.ends_with("inter")  ? CallKind::kInter
                                                   : CallKind::kIntra;
  const Ids ids(room, objects);
  CallMatcher matcher(sentences, objects, kind == CallKind::kTertiary);
  for (const v1::ConstraintEdge& edge : room.graph.edges()) {
    const bool own = KindOf(edge, room) == kind;
    const bool known = functions.contains(edge.type());
    RecordedCall call;
    const bool there = ReadCall(edge, known ? functions[edge.type()] : std::vector<std::string>(), ids, call);
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
