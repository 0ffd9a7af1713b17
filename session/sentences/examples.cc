// SPDX-License-Identifier: GPL-3.0-or-later
// What can be said instead: of the verb and the pieces that were spoken of, as far as any were.
#include <algorithm>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "english/language.h"
#include "english/words.h"
#include "fmt/format.h"
#include "session/sentences/answers.h"

namespace flair::session {
namespace {

// Pieces that a text names by their names or the last words of these, in its order; of a name the first one.
ObjectIds PiecesIn(const Tokens& tokens, const v1::SolvedLayout& layout) {
  ObjectIds ids;
  for (const english::Token& token : tokens) {
    const std::string word = english::Singular(token.text);
    for (const v1::Object& object : layout.graph().object_list().objects()) {
      const std::string name = absl::AsciiStrToLower(object.name());
      const bool named = name == word || absl::EndsWith(name, " " + word);
      if (!named || PlaceOf(layout, object.id()) == nullptr) continue;
      if (std::ranges::find(ids, object.id()) == ids.end()) ids.push_back(object.id());
      break;
    }
  }
  return ids;
}

// Fills the slots of an example with pieces of the room: first those that were spoken of, then others at other turns.
class Example {
 public:
  Example(const v1::SolvedLayout& layout, unsigned turn, ObjectIds said = {})
      : layout_(layout), turn_(turn), said_(std::move(said)) {}

  // Empty when the room has nothing for a slot.
  std::string Fill(std::string form) {
    for (size_t at = form.find('{'); at != std::string::npos; at = form.find('{')) {
      const size_t end = form.find('}', at);
      const std::string name = Pick(form.substr(at + 1, end - at - 1));
      if (name.empty()) return "";
      constexpr std::string_view kThe = "the ";
      const bool has_the = at >= kThe.size() && form.substr(at - kThe.size(), kThe.size()) == kThe;
      // "Nightstand 2" has no article.
      const size_t begin = has_the ? at - kThe.size() : at;
      form.replace(begin, end - begin + 1, has_the || !name.starts_with(kThe) ? name : name.substr(kThe.size()));
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
    for (const std::string& id : said_) {
      if (used_.insert(id).second) return TheOnes(layout_, {id});
    }
    ObjectIds ids;
    std::set<std::string> names;
    for (const v1::Object& object : layout_.graph().object_list().objects()) names.insert(object.name());
    for (const v1::Object& object : layout_.graph().object_list().objects()) {
      if (PlaceOf(layout_, object.id()) == nullptr || !Fits(slot, object) || used_.contains(object.id())) continue;
      const auto same = [&](const v1::Object& other) { return other.name() == object.name(); };
      if (std::ranges::count_if(layout_.graph().object_list().objects(), same) == 1) ids.push_back(object.id());
    }
    if (ids.empty()) return "";
    const std::string id = ids[turn_ % ids.size()];
    used_.insert(id);
    return TheOnes(layout_, {id});
  }

  const v1::SolvedLayout& layout_;
  const unsigned turn_;
  const ObjectIds said_;
  IdSet used_;
};

// The example whose verb the tokens have; empty when there is none.
std::string FormOfVerb(const Tokens& tokens) {
  static const WordMeanings forms("example: ");
  for (size_t at = 0; at < tokens.size(); ++at) {
    const size_t length = forms.LengthAt(tokens, at);
    if (length > 0) return *forms.Find(tokens, {at, at + length});
  }
  return "";
}

}  // namespace

std::string Examples(const std::string& text, const v1::SolvedLayout& layout, unsigned turn) {
  constexpr size_t kShown = 2;
  const Tokens tokens = PlainTokens(text);
  const ObjectIds said = PiecesIn(tokens, layout);
  std::vector<std::string> forms, shown;
  for (const auto& list : english::Language::Get().data().lists()) {
    if (list.name() == "examples of edits") forms.assign(list.words().begin(), list.words().end());
  }
  const auto show = [&](const std::string& example) {
    if (!example.empty()) shown.push_back(fmt::format("\"{}\"", example));
  };
  if (const std::string form = FormOfVerb(tokens); !form.empty()) show(Example(layout, turn, said).Fill(form));
  if (!shown.empty()) return "say for example " + shown.front();
  const size_t first = turn * kShown;
  for (size_t i = 0; i < forms.size() && shown.size() < kShown; ++i) {
    // One with pieces comes before one without.
    const std::string& form = forms[(first + i) % forms.size()];
    if (!said.empty() && form.find('{') == std::string::npos) continue;
    show(Example(layout, turn + static_cast<unsigned>(i), said).Fill(form));
  }
  return "say for example " + Listed(shown, "or");
}

}  // namespace flair::session
