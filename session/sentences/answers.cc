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

// Fills the slots of an example with pieces of the room, other ones at other turns.
class Example {
 public:
  Example(const v1::SolvedLayout& layout, unsigned turn) : layout_(layout), turn_(turn) {}

  // Empty when the room has nothing for a slot.
  std::string Fill(std::string form) {
    for (size_t at = form.find('{'); at != std::string::npos; at = form.find('{')) {
      const size_t end = form.find('}', at);
      const std::string name = Pick(form.substr(at + 1, end - at - 1));
      if (name.empty()) return "";
      form.replace(at, end - at + 1, name);
    }
    return form;
  }

 private:
  static bool Fits(const std::string& slot, const v1::Object& object) {
    const bool floor = object.kind() == v1::OBJECT_KIND_FLOOR && !object.walk_over();
    if (slot == "rug") return object.walk_over();
    if (slot == "small") return object.kind() == v1::OBJECT_KIND_WALL || object.kind() == v1::OBJECT_KIND_SURFACE;
    if (slot == "seat") return floor && object.seat();
    if (slot == "table") return floor && (object.sat_at() || absl::EndsWith(object.name(), "table"));
    return floor;
  }

  std::string Pick(const std::string& slot) {
    std::vector<std::string> names;
    for (const v1::Object& object : layout_.graph().object_list().objects()) {
      if (PlaceOf(layout_, object.id()) == nullptr || !Fits(slot, object)) continue;
      if (CountOf(layout_, object.name()) == 1 && !used_.contains(object.name())) names.push_back(object.name());
    }
    if (names.empty()) return "";
    const std::string name = names[turn_ % names.size()];
    used_.insert(name);
    return name;
  }

  const v1::SolvedLayout& layout_;
  const unsigned turn_;
  IdSet used_;
};

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

std::string Examples(const v1::SolvedLayout& layout, unsigned turn) {
  constexpr size_t kShown = 2;
  std::vector<std::string> forms;
  for (const auto& list : english::Language::Get().data().lists()) {
    if (list.name() == "examples of edits") forms.assign(list.words().begin(), list.words().end());
  }
  std::vector<std::string> shown;
  const size_t first = turn * kShown;
  for (size_t i = 0; i < forms.size() && shown.size() < kShown; ++i) {
    // One with pieces comes before one without.
    const std::string text = Example(layout, turn + static_cast<unsigned>(i)).Fill(forms[(first + i) % forms.size()]);
    if (!text.empty()) shown.push_back(fmt::format("\"{}\"", text));
  }
  return "say for example " + Listed(shown, "or");
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
