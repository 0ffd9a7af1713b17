// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sentences/answers.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "english/language.h"
#include "english/lexicon.h"
#include "english/quantities.h"
#include "english/words.h"
#include "fmt/format.h"
#include "room/conversion/conversion.h"

namespace flair::session {
namespace {

size_t CountOf(const v1::SolvedLayout& layout, const std::string& name) {
  return static_cast<size_t>(std::ranges::count(layout.graph().object_list().objects(), name, &v1::Object::name));
}

}  // namespace

std::string Listed(const std::vector<std::string>& words, const std::string& join) {
  if (words.size() < 2) return absl::StrJoin(words, "");
  const std::vector<std::string> first(words.begin(), words.end() - 1);
  return fmt::format("{} {} {}", absl::StrJoin(first, ", "), join, words.back());
}

std::string Capital(std::string text) {
  if (!text.empty()) text[0] = absl::ascii_toupper(static_cast<unsigned char>(text[0]));
  return text;
}

std::string TheOnes(const v1::SolvedLayout& layout, const ObjectIds& ids) {
  constexpr size_t kMost = 3;
  std::vector<std::pair<std::string, ObjectIds>> by_name;
  for (const std::string& id : ids) {
    const v1::Object* const object = ObjectOf(layout, id);
    const std::string name = object == nullptr ? id : object->name();
    auto kind = std::ranges::find(by_name, name, &std::pair<std::string, ObjectIds>::first);
    if (kind == by_name.end()) kind = by_name.insert(by_name.end(), {name, {}});
    kind->second.push_back(id);
  }
  const absl::StatusOr<Scene> scene = SceneFromProto(layout.graph());
  std::vector<std::string> texts;
  for (const auto& [name, of_name] : by_name) {
    if (of_name.size() > 1) {
      const size_t space = name.rfind(' ');
      const size_t last = space == std::string::npos ? 0 : space + 1;
      const std::string plural = name.substr(0, last) + english::Plural(name.substr(last));
      const char* const the = CountOf(layout, name) == of_name.size() ? "the " : "";
      texts.push_back(fmt::format("{}{} {}", the, of_name.size(), plural));
    } else {
      const int index = scene.ok() ? scene->IndexOf(of_name.front()) : -1;
      texts.push_back(index < 0 ? "the " + name : NameForPeople(*scene, index));
    }
  }
  if (texts.size() > kMost) {
    const size_t more = texts.size() - kMost + 1;
    texts.resize(kMost - 1);
    texts.push_back(fmt::format("{} others", more));
  }
  return Listed(texts, "and");
}

std::string MovedToo(const v1::SolvedLayout& layout, const ObjectIds& moved_ids, const IdSet& about) {
  ObjectIds others;
  for (const std::string& id : moved_ids) {
    if (!about.contains(id)) others.push_back(id);
  }
  return others.empty() ? "" : fmt::format(" {} moved too.", Capital(TheOnes(layout, others)));
}

std::string NewFault(const v1::SolvedLayout& before, const v1::SolvedLayout& after) {
  IdSet known;
  for (const v1::Finding& finding : before.metrics().findings()) known.insert(finding.message());
  for (const v1::Finding& finding : after.metrics().findings()) {
    const bool use = finding.kind() == v1::FINDING_KIND_USE_NOT_MET;
    if (!use && !known.contains(finding.message())) return finding.message();
  }
  return "something is in the way";
}

std::string AtACost(const v1::SolvedLayout& before, const v1::SolvedLayout& after, const IdSet& about) {
  // By what it is about: figures in messages change.
  std::set<std::tuple<int, std::string, std::string>> known;
  const auto key = [](const v1::Finding& one) {
    return std::tuple(static_cast<int>(one.kind()), one.object_id(), one.partner_id());
  };
  for (const v1::Finding& finding : before.metrics().findings()) known.insert(key(finding));
  for (const v1::Finding& finding : after.metrics().findings()) {
    const bool named = about.contains(finding.object_id()) || about.contains(finding.partner_id());
    if (named && !known.contains(key(finding))) return fmt::format(" But {}.", finding.message());
  }
  return "";
}

std::string HarmDone(const v1::SolvedLayout& before, const v1::SolvedLayout& after,
                     const std::vector<v1::Diagnostic>& remarks, const std::string& answer) {
  constexpr double kNoticed = 0.03, kNone = 0.01;
  constexpr size_t kMost = 3;
  std::vector<std::string> harms;
  const double was = before.metrics().reachable_floor_share(), is = after.metrics().reachable_floor_share();
  const bool told_by_remark = std::ranges::any_of(remarks, [](const auto& one) { return one.code() == "way_blocked"; });
  if (is < kNone && was >= kNone) {
    harms.emplace_back("nobody gets into the room by the door any more");
  } else if (was - is > kNoticed && !told_by_remark) {
    harms.push_back(fmt::format("only {:.0f} % of the free floor can be reached from the door, {:.0f} % before",
                                100 * is, 100 * was));
  }
  for (const v1::Diagnostic& remark : remarks) {
    if (remark.code() == "way_blocked" || remark.code() == "front_blocked") harms.push_back(remark.message());
  }
  std::set<std::tuple<int, std::string, std::string>> known;
  const auto key = [](const v1::Finding& one) {
    return std::tuple(static_cast<int>(one.kind()), one.object_id(), one.partner_id());
  };
  for (const v1::Finding& finding : before.metrics().findings()) known.insert(key(finding));
  IdSet asked;
  for (const v1::ConstraintEdge& edge : after.graph().edges()) asked.insert(edge.sentence_id());
  for (const v1::Finding& finding : after.metrics().findings()) {
    const bool is_use = finding.kind() == v1::FINDING_KIND_USE_NOT_MET;
    // A use that nothing asks for any more went with its piece.
    if (is_use && !asked.contains(finding.sentence_id())) continue;
    if (!known.contains(key(finding)) && (!is_use || harms.empty())) harms.push_back(finding.message());
  }
  std::erase_if(harms, [&](const std::string& harm) { return absl::StrContains(answer, harm); });
  if (harms.size() > kMost) harms.resize(kMost);
  if (harms.empty()) return "";
  return fmt::format(" {} {}.", absl::StrContains(answer, " But ") ? "And" : "But", absl::StrJoin(harms, "; "));
}

std::string UnknownWord(const std::string& text, const v1::SolvedLayout& layout, const FindPiece& find) {
  static const IdSet& known = *[] {
    auto* words = new IdSet;
    for (const auto& list : english::Language::Get().data().lists()) {
      for (const std::string& phrase : list.words()) {
        for (const english::Token& token : english::Tokenize(phrase)) words->insert(token.text);
      }
    }
    return words;
  }();
  IdSet here;
  const auto add = [&](const std::string& name) {
    for (const english::Token& token : english::Tokenize(absl::StrReplaceAll(name, {{"_", " "}}))) {
      here.insert(token.text);
    }
  };
  for (const v1::Object& object : layout.graph().object_list().objects()) add(object.name());
  for (const v1::Wall& wall : layout.graph().room().walls()) add(wall.name());
  const Tokens tokens = PlainTokens(text);
  for (size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind != english::Token::Kind::kWord) continue;
    const std::string& word = tokens[i].text;
    const std::string singular = english::Singular(word);
    const auto is_known = [&](const std::string& one) {
      return known.contains(one) || here.contains(one) || find(one).has_value();
    };
    const english::Lexicon& lexicon = english::Lexicon::Get();
    if (is_known(word) || is_known(singular) || english::NumberOf(word).has_value()) continue;
    if (english::Language::Get().FindUnit(word) != nullptr) continue;
    if (lexicon.Find(tokens, i).length == 0 && lexicon.FindForm(tokens[i]).length == 0) return word;
  }
  return "";
}

}  // namespace flair::session
