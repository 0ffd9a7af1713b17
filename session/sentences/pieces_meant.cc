// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sentences/pieces_meant.h"

#include <algorithm>
#include <cmath>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/numbers.h"
#include "english/quantities.h"
#include "english/words.h"
#include "session/sentences/told_places.h"

namespace flair::session {
namespace {

using english::IsIn;
using english::Token;

constexpr size_t kLongestCalled = 5;

bool IsWord(const Token& token) { return token.kind == Token::Kind::kWord; }

// What may stand between a determiner and a name.
bool IsAdjective(const Token& token) {
  static const std::vector<std::string> kNone = {
      "words after a piece",      "joins of clauses",        "pronouns of a piece", "beginnings of places",
      "verbs that begin an edit", "words for one of a kind", "requests for a piece"};
  return IsWord(token) && std::ranges::none_of(kNone, [&](const std::string& list) { return IsIn(list, token); });
}

// The first word that is no adjective, so that it must be of the name itself: "chest of drawers", "tv stand".
size_t FirstOfName(const Tokens& tokens, Span span) {
  size_t at = span.begin;
  while (at < span.end && IsAdjective(tokens[at])) ++at;
  return at;
}

// "Chests of drawers" are each a chest of drawers.
std::string NameIn(const Tokens& tokens, Span span) {
  size_t noun = span.end - 1;
  for (size_t i = span.begin + 1; i < span.end; ++i) {
    if (tokens[i].IsWord("of")) noun = std::min(noun, i - 1);
  }
  std::string name;
  for (size_t i = span.begin; i < span.end; ++i) {
    if (!name.empty()) name += ' ';
    name += i == noun ? english::Singular(tokens[i].text) : tokens[i].text;
  }
  return name;
}

bool IsJoin(const Token& token) { return token.IsMark(',') || token.IsWord("and") || token.IsWord("plus"); }

// What stands before a name, as "the two left", "all", "another".
struct Before {
  size_t end = 0;
  std::optional<int> count = {};
  int ordinal = 0;
  std::string side = {};
  bool is_known = false, is_all = false, is_one = false;
};

Before ReadBefore(const Tokens& tokens, Span span) {
  static const WordMeanings ordinals("ordinal: "), ends("end: ");
  Before before{.end = span.begin};
  while (before.end + 1 < span.end) {
    const Span at{before.end, before.end + 1};
    const Token& token = tokens[before.end];
    const std::string *const ordinal = ordinals.Find(tokens, at), *const side = ends.Find(tokens, at);
    const bool digits = token.kind == Token::Kind::kNumber;
    const double number = digits ? token.number : IsWord(token) ? english::NumberOf(token.text).value_or(0) : 0;
    if (IsIn("words for all of a kind", token)) {
      before.is_all = true;
    } else if (IsIn("words for one of a kind", token)) {
      before.is_one = true;
    } else if (ordinal != nullptr) {
      if (!absl::SimpleAtoi(*ordinal, &before.ordinal)) before.ordinal = 0;
    } else if (side != nullptr) {
      before.side = *side;
    } else if (number > 0) {
      before.count = static_cast<int>(std::clamp(std::round(number), 1.0, 12.0));
    } else if (IsIn("determiners of known things", token)) {
      before.is_known = true;
    } else if (!IsIn("words before a known piece", token) && !IsIn("beginnings of more", token)) {
      break;
    }
    ++before.end;
  }
  return before;
}

}  // namespace

const v1::Object* AnotherOf(const v1::LayoutGraph& graph, const std::string& name, const FindPiece& find) {
  const v1::Object* like = nullptr;
  bool is_one_kind = true;
  for (const v1::Object& object : graph.object_list().objects()) {
    const std::string low = absl::AsciiStrToLower(object.name());
    if (low == name) return &object;
    if (!absl::EndsWith(low, " " + name)) continue;
    is_one_kind = is_one_kind && (like == nullptr || like->name() == object.name());
    if (like == nullptr) like = &object;
  }
  if (like == nullptr || !is_one_kind) return nullptr;
  // "Table" is any table; "coffee table" is that, and a plant of the floor is none of a shelf.
  const std::optional<v1::Object> known = find(name);
  if (!known.has_value()) return like;
  return absl::AsciiStrToLower(known->name()) == name || known->kind() != like->kind() ? nullptr : like;
}

std::vector<std::string> MeantPieces::Kinds(const ObjectIds& ids) const {
  std::vector<std::string> kinds;
  for (const std::string& id : ids) {
    const v1::Object* const object = ObjectOf(layout_, id);
    if (object != nullptr && std::ranges::find(kinds, object->name()) == kinds.end()) kinds.push_back(object->name());
  }
  return kinds;
}

ObjectIds MeantPieces::Called(const std::string& name) const {
  const std::optional<v1::Object> known = find_(name);
  const std::string of_class = known.has_value() ? absl::AsciiStrToLower(known->name()) : "";
  ObjectIds exact, other;
  for (const v1::Object& object : layout_.graph().object_list().objects()) {
    if (PlaceOf(layout_, object.id()) == nullptr) continue;
    const std::string low = absl::AsciiStrToLower(object.name());
    if (low == name || object.id() == name) {
      exact.push_back(object.id());
    } else if (low == of_class || absl::EndsWith(low, " " + name)) {
      other.push_back(object.id());
    }
  }
  return exact.empty() ? other : exact;
}

void MeantPieces::Narrow(int ordinal, const std::string& end, std::optional<int> count, Meant& meant) const {
  ObjectIds& ids = meant.ids;
  if (!end.empty()) {
    std::ranges::stable_sort(ids, {}, [&](const std::string& id) {
      const v1::Placement& at = *PlaceOf(layout_, id);
      return end == "west" ? at.x_m() : end == "east" ? -at.x_m() : end == "south" ? at.y_m() : -at.y_m();
    });
    ids.resize(std::min<size_t>(ids.size(), static_cast<size_t>(count.value_or(1))));
    meant.is_chosen = true;
  } else if (ordinal != 0) {
    const int at = ordinal < 0 ? static_cast<int>(ids.size()) - 1 : ordinal - 1;
    ids = at < static_cast<int>(ids.size()) ? ObjectIds{ids[at]} : ObjectIds();
    meant.is_chosen = true;
  } else if (count.has_value() && *count < static_cast<int>(ids.size())) {
    // The latest ones: who wants fewer chairs keeps those that were there first.
    ids.erase(ids.begin(), ids.end() - *count);
    meant.is_chosen = true;
  }
}

std::optional<Meant> MeantPieces::FindTold(const Tokens& tokens, const ToldPlace& told) const {
  std::optional<Meant> meant = FindOne(tokens, told.head);
  if (!meant.has_value()) return std::nullopt;
  if (told.tail.empty()) {
    meant->ids = StandingFarthest(meant->ids, told.relation, layout_);
  } else if (std::optional<ObjectIds> there = StandingThere(meant->ids, told.relation, tokens, told.tail, layout_)) {
    meant->ids = *std::move(there);
  } else {
    const std::optional<Meant> at = FindOne(tokens, told.tail);
    if (!at.has_value() || at->is_new) return std::nullopt;
    meant->ids = StandingThere(meant->ids, told.relation, at->ids, layout_);
  }
  if (meant->ids.empty()) return std::nullopt;
  meant->is_one = meant->is_one && meant->ids.size() > 1;
  meant->is_chosen = true;
  // "A chair by the window" may be any.
  meant->is_told = !meant->is_new;
  return meant;
}

std::optional<Meant> MeantPieces::FindOne(const Tokens& tokens, Span span) const {
  if (const std::optional<ToldPlace> told = ReadToldPlace(tokens, span)) return FindTold(tokens, *told);
  const Before before = ReadBefore(tokens, span);
  Span name{before.end, span.end};
  int ordinal = before.ordinal;
  // "Dining chair 2".
  if (name.end - name.begin > 1 && tokens[name.end - 1].kind == Token::Kind::kNumber) {
    ordinal = static_cast<int>(tokens[--name.end].number);
  }
  if (name.empty()) return std::nullopt;
  const size_t latest = std::min(FirstOfName(tokens, name), name.end - 1);
  for (size_t first = name.end - std::min(kLongestCalled, name.end - name.begin); first <= latest; ++first) {
    Meant meant{.name = NameIn(tokens, {first, name.end})};
    meant.ids = Called(meant.name);
    if (meant.ids.empty()) {
      // Visitor chairs are no office chairs; a nice chair may be one.
      if (find_(meant.name).has_value()) return std::nullopt;
      continue;
    }
    const bool plural = english::IsPlural(tokens[name.end - 1].text);
    ObjectIds selected;
    std::ranges::copy_if(meant.ids, std::back_inserter(selected),
                         [&](const std::string& id) { return selected_.contains(id); });
    if (!selected.empty() && !before.is_all && !before.count && ordinal == 0 && before.side.empty()) {
      meant.ids = selected;
      meant.is_chosen = true;
    }
    Narrow(ordinal, before.side, before.count, meant);
    if (meant.ids.empty()) return std::nullopt;
    meant.is_one = meant.ids.size() > 1 && (before.is_one || !plural) && !before.is_all && !before.count;
    meant.is_new = !before.is_known && !before.is_all && (before.is_one || before.count.has_value());
    return meant;
  }
  return std::nullopt;
}

std::optional<Meant> MeantPieces::Find(const Tokens& tokens, Span span) const {
  static const WordMeanings pronouns("words for the pieces meant"), all("kind: all");
  if (span.empty()) return std::nullopt;
  if (pronouns.Find(tokens, span) != nullptr) {
    Meant meant{.is_chosen = true};
    if (selected_.empty()) {
      meant.ids = last_;
    } else {
      meant.ids.assign(selected_.begin(), selected_.end());
    }
    std::erase_if(meant.ids, [&](const std::string& id) { return PlaceOf(layout_, id) == nullptr; });
    return meant.ids.empty() ? std::nullopt : std::optional(meant);
  }
  if (all.Find(tokens, span) != nullptr) {
    Meant meant{.is_chosen = true, .is_all = true};
    for (const v1::Object& object : layout_.graph().object_list().objects()) meant.ids.push_back(object.id());
    return meant;
  }
  if (std::optional<Meant> one = FindOne(tokens, span); one.has_value()) return one;
  Meant meant;
  size_t begin = span.begin;
  for (size_t i = span.begin; i <= span.end; ++i) {
    if (i < span.end && !IsJoin(tokens[i])) continue;
    if (i > begin) {
      const std::optional<Meant> part = FindOne(tokens, {begin, i});
      if (!part.has_value()) {
        const std::string name = NameOfAbsent(tokens, {begin, i});
        if (name.empty() || !IsIn("determiners of known things", tokens[begin])) return std::nullopt;
        meant.absent.push_back(name);
        begin = i + 1;
        continue;
      }
      ObjectIds ids = part->ids;
      if (part->is_one) ids.resize(1);
      meant.ids.insert(meant.ids.end(), ids.begin(), ids.end());
      meant.is_new = meant.is_new || part->is_new;
    }
    begin = i + 1;
  }
  meant.is_chosen = true;
  return meant.ids.empty() ? std::nullopt : std::optional(meant);
}

std::optional<Wanted> MeantPieces::FindNew(const Tokens& tokens, Span span) const {
  const Before before = ReadBefore(tokens, span);
  const Span name{before.end, span.end};
  if (name.empty()) return std::nullopt;
  const size_t latest = std::min(FirstOfName(tokens, name), name.end - 1);
  for (size_t first = name.end - std::min(kLongestCalled, name.end - name.begin); first <= latest; ++first) {
    const std::string called = NameIn(tokens, {first, name.end});
    Wanted wanted{.count = before.count.value_or(1), .is_plural = english::IsPlural(tokens[name.end - 1].text)};
    if (const v1::Object* const like = AnotherOf(layout_.graph(), called, find_); like != nullptr) {
      wanted.object = *like;
      wanted.like_id = like->id();
      return wanted;
    }
    if (std::optional<v1::Object> known = find_(called); known.has_value()) {
      wanted.object = *std::move(known);
      return wanted;
    }
  }
  return std::nullopt;
}

std::string MeantPieces::NameOfAbsent(const Tokens& tokens, Span span) const {
  constexpr size_t kMostWords = 4;
  if (const std::optional<ToldPlace> told = ReadToldPlace(tokens, span)) {
    const std::string head = NameOfAbsent(tokens, told->head);
    if (head.empty() || Called(head).empty()) return head;
    std::string where = head;
    for (size_t i = told->head.end; i < span.end; ++i) where += " " + tokens[i].text;
    return where;
  }
  const Before before = ReadBefore(tokens, span);
  const Span name{before.end, span.end};
  const bool plain =
      !name.empty() && name.end - name.begin <= kMostWords &&
      std::all_of(tokens.begin() + static_cast<long>(name.begin), tokens.begin() + static_cast<long>(name.end),
                  [](const Token& token) { return IsAdjective(token) && !IsIn("verbs that begin an edit", token); });
  if (!plain) return "";
  const std::string called = NameIn(tokens, name);
  if (find_(called).has_value()) return called;
  // "The wardrobe upside" is the wardrobe and something that is not understood.
  for (size_t end = name.begin + 1; end < name.end; ++end) {
    if (!Called(NameIn(tokens, {name.begin, end})).empty()) return "";
  }
  return called;
}

}  // namespace flair::session
