// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sentences/spoken.h"

#include <algorithm>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "english/quantities.h"
#include "english/words.h"
#include "session/sentences/asides.h"

namespace flair::session {
namespace {

using english::IsIn;
using english::Token;

const WordMeanings& Polite() {
  static const WordMeanings words("polite before an edit");
  return words;
}

// Where it may end when thanks and the like are left off, the shortest first.
std::vector<size_t> EndsOf(const Tokens& tokens, Span span) {
  static const WordMeanings polite("polite after an edit");
  constexpr size_t kLongest = 4;
  std::vector<size_t> ends = {span.end};
  for (size_t end = span.end; end > span.begin;) {
    size_t next = end;
    if (tokens[end - 1].IsMark(',')) next = end - 1;
    for (size_t length = std::min(kLongest, end - span.begin); next == end && length > 0; --length) {
      if (polite.Find(tokens, {end - length, end}) != nullptr) next = end - length;
    }
    if (next == end) break;
    ends.push_back(end = next);
  }
  std::ranges::reverse(ends);
  return ends;
}

bool BeginsEdit(const Tokens& tokens, Span span) {
  const size_t at = WithoutPolite(tokens, span);
  if (at >= span.end) return false;
  if (IsIn("verbs that begin an edit", tokens[at])) return true;
  const bool counted = tokens[at].kind == Token::Kind::kNumber || english::NumberOf(tokens[at].text).has_value();
  return counted && at + 1 < span.end && IsIn("beginnings of more", tokens[at + 1]);
}

bool IsClauseJoin(const Token& token) { return token.IsMark(',') || IsIn("joins of clauses", token); }

// Where one clause of the span may end and another begin, as the join between them, the last first.
std::vector<size_t> JoinsIn(const Tokens& tokens, Span span) {
  std::vector<size_t> joins;
  for (size_t i = span.end; i-- > span.begin + 1;) {
    if ((IsClauseJoin(tokens[i]) || ReasonAt(tokens, i) > 0) && i + 1 < span.end) joins.push_back(i);
  }
  return joins;
}

std::optional<double> LengthIn(const Tokens& tokens, Span span) {
  const std::optional<english::Measure> measure = english::MeasureAt(tokens, span.begin);
  if (!measure.has_value() || measure->end != span.end || measure->unit <= 0 || measure->value <= 0)
    return std::nullopt;
  return measure->value;
}

struct Meanings {
  WordMeanings ways{"way: "}, hands{"hand: "}, angles{"angle: "}, degrees{"degree: "}, factors{"factor: "},
      more{"more: "}, less{"less: "}, lacks{"lack: "}, plain{"plain: "}, targets{"target: "}, motion{"kind: motion"},
      away{"kind: away"}, layouts{"kind: layouts"}, all{"kind: all"};
  static const Meanings& Get() {
    static const auto* const meanings = new Meanings;
    return *meanings;
  }
};

// "2.4 by 2.2 m": a unit counts for those before it that have none; without any they are metres.
std::vector<double> SizeIn(const Tokens& tokens, Span span) {
  std::vector<double> values;
  std::vector<bool> bare;
  double unit = 1;
  for (size_t at = span.begin;;) {
    const std::optional<english::Measure> one = english::MeasureAt(tokens, at);
    if (!one.has_value() || one->end > span.end || one->value <= 0) return {};
    values.push_back(one->value);
    bare.push_back(one->unit <= 0);
    if (one->unit > 0) unit = one->unit;
    at = one->end;
    // "2.4 m long and 2.2 m wide".
    if (at < span.end && Meanings::Get().plain.Find(tokens, {at, at + 1}) != nullptr) ++at;
    if (at == span.end) break;
    const bool joined = tokens[at].IsWord("by") || tokens[at].IsWord("x") || tokens[at].IsWord("times") ||
                        tokens[at].IsWord("and") || tokens[at].IsMark('*');
    if (!joined || ++at >= span.end) return {};
  }
  if (values.size() < 2 || values.size() > 3) return {};
  // "200 by 150" are centimetres.
  constexpr double kMostMetres = 20;
  if (std::ranges::all_of(bare, [](bool one) { return one; }) && values[0] > kMostMetres) unit = 0.01;
  for (size_t i = 0; i < values.size(); ++i) {
    if (bare[i]) values[i] *= unit;
  }
  return values;
}

std::string TextOf(std::string_view text, const Tokens& tokens, Span span) {
  if (span.empty()) return "";
  const size_t begin = tokens[span.begin].begin;
  return std::string(text.substr(begin, tokens[span.end - 1].end - begin));
}

// "more long".
std::string ChangeIn(const Tokens& tokens, Span span) {
  const Meanings& meanings = Meanings::Get();
  if (const std::string* more = meanings.more.Find(tokens, span)) return "more " + *more;
  if (const std::string* less = meanings.less.Find(tokens, span)) return "less " + *less;
  return "";
}

std::optional<double> AngleIn(const Tokens& tokens, Span span) {
  if (const std::string* named = Meanings::Get().angles.Find(tokens, span)) {
    double degrees = 0;
    return absl::SimpleAtod(*named, &degrees) ? std::optional(degrees) : std::nullopt;
  }
  const auto measure = english::MeasureAt(tokens, span.begin, english::v1::Unit::KIND_ANGLE);
  // "By 90" are degrees.
  constexpr double kLeastBare_deg = 10;
  if (!measure.has_value() || measure->end != span.end) return std::nullopt;
  return measure->unit > 0 || measure->value >= kLeastBare_deg ? std::optional(measure->value) : std::nullopt;
}

}  // namespace

size_t WithoutPolite(const Tokens& tokens, Span span) {
  size_t begin = span.begin;
  while (begin < span.end) {
    if (tokens[begin].IsMark(',')) {
      ++begin;
      continue;
    }
    const size_t length = Polite().LengthAt(tokens, begin);
    if (length == 0) break;
    begin += length;
  }
  return begin;
}

std::optional<Meant> SpokenReader::Find(const Tokens& tokens, Span span) {
  const auto [at, is_new] = meant_.try_emplace({span.begin, span.end});
  if (is_new) at->second = pieces_.Find(tokens, span);
  return at->second;
}

std::optional<Target> SpokenReader::FindTarget(const Tokens& tokens, Span span) const {
  Target target;
  std::vector<std::string> words;
  for (size_t i = span.begin; i < span.end; ++i) words.push_back(tokens[i].text);
  target.said = absl::StrJoin(words, " ");
  if (const std::string* kind = Meanings::Get().targets.Find(tokens, span)) {
    target.kind = *kind;
    return target;
  }
  if (words.size() > 1 && words.back() == "wall") {
    if (words.front() == "the") words.erase(words.begin());
    words.pop_back();
    const std::string said = absl::StrJoin(words, " ");
    for (size_t i = 0; i < room_.walls.size(); ++i) {
      const std::string name = absl::StrReplaceAll(absl::AsciiStrToLower(room_.walls[i].name), {{"_", " "}});
      if (name != said && WallName(room_, room_.walls[i]) != "the " + said + " wall") continue;
      target.kind = "wall";
      target.wall = static_cast<int>(i);
      return target;
    }
  }
  std::optional<Meant> pieces = pieces_.Find(tokens, span);
  if (!pieces.has_value() || pieces->is_all) return std::nullopt;
  target.kind = "object";
  target.ids = pieces->ids;
  return target;
}

bool SpokenReader::Fits(const Tokens& tokens, const std::string& slot, Span span) {
  const Meanings& meanings = Meanings::Get();
  const std::string kind = slot.substr(0, slot.find(':'));
  if (kind == "what" || kind == "other") {
    if (Find(tokens, span).has_value()) return true;
    return is_lenient_ && kind == "what" && !pieces_.NameOfAbsent(tokens, span).empty();
  }
  if (kind == "new") {
    const std::optional<Wanted> wanted = pieces_.FindNew(tokens, span);
    if (!wanted.has_value()) return false;
    // "Swap the sofa with the shelf" is no wish for another shelf.
    const std::optional<Meant> there = Find(tokens, span);
    return slot == "new:any" || !there.has_value() || there->is_new;
  }
  if (kind == "length") return LengthIn(tokens, span).has_value();
  if (kind == "size") return !SizeIn(tokens, span).empty();
  if (kind == "more" || kind == "also") return !ChangeIn(tokens, span).empty();
  if (kind == "less") return meanings.less.Find(tokens, span) != nullptr;
  if (kind == "lack") return meanings.lacks.Find(tokens, span) != nullptr;
  if (kind == "plain" || kind == "dim") return meanings.plain.Find(tokens, span) != nullptr;
  if (kind == "degree") return meanings.degrees.Find(tokens, span) != nullptr;
  if (kind == "factor") return meanings.factors.Find(tokens, span) != nullptr;
  if (kind == "way" || kind == "compass") return meanings.ways.Find(tokens, span) != nullptr;
  if (kind == "compass side") {
    // Left and right may be those of the piece.
    const std::string* const way = meanings.ways.Find(tokens, span);
    return way != nullptr && tokens[span.end - 1].text == *way;
  }
  if (kind == "hand") return meanings.hands.Find(tokens, span) != nullptr;
  if (kind == "angle") return AngleIn(tokens, span).has_value();
  if (kind == "motion") return meanings.motion.Find(tokens, span) != nullptr;
  if (kind == "away") return meanings.away.Find(tokens, span) != nullptr;
  if (kind == "layouts") return meanings.layouts.Find(tokens, span) != nullptr;
  if (kind == "all") return meanings.all.Find(tokens, span) != nullptr;
  if (kind == "target") return FindTarget(tokens, span).has_value();
  if (kind == "opening") {
    const std::optional<Target> target = FindTarget(tokens, span);
    return target.has_value() && target->kind != "object";
  }
  if (kind == "place") {
    if (!IsIn("beginnings of places", tokens[span.begin]) || IsNoStatement(tokens, span)) return false;
    for (size_t at = span.begin + 1; at < span.end; ++at) {
      if (ReasonAt(tokens, at) > 0) return false;
    }
    if (span.begin + 1 < span.end && IsIn("verbs after to", tokens[span.begin + 1])) return false;
    return std::ranges::none_of(JoinsIn(tokens, span), [&](size_t join) {
      return BeginsEdit(tokens, {join + 1, span.end});
    });
  }
  return false;
}

void SpokenReader::Fill(const Tokens& tokens, const std::string& slot, Span span, Spoken& spoken) const {
  const Meanings& meanings = Meanings::Get();
  const std::string kind = slot.substr(0, slot.find(':'));
  if (kind == "what") {
    if (std::optional<Meant> meant = pieces_.Find(tokens, span)) {
      spoken.what = *std::move(meant);
    } else {
      spoken.absent = pieces_.NameOfAbsent(tokens, span);
    }
    // "Too many chairs", "one chair less": one of them goes.
    if (slot == "what:one" && spoken.what.ids.size() > 1) spoken.what.is_one = true;
  } else if (kind == "other") {
    spoken.other = pieces_.Find(tokens, span).value_or(Meant());
  } else if (kind == "new") {
    spoken.by = pieces_.FindNew(tokens, span);
  } else if (kind == "length") {
    spoken.length_m = LengthIn(tokens, span);
  } else if (kind == "size") {
    spoken.size_m = SizeIn(tokens, span);
  } else if (kind == "more" || kind == "also" || kind == "less") {
    spoken.changes.push_back(ChangeIn(tokens, span));
  } else if (kind == "lack") {
    spoken.changes.push_back(*meanings.lacks.Find(tokens, span));
  } else if (kind == "plain" || kind == "dim") {
    spoken.dimension = *meanings.plain.Find(tokens, span);
  } else if (kind == "degree" || kind == "factor") {
    const std::string* value = (kind == "degree" ? meanings.degrees : meanings.factors).Find(tokens, span);
    if (!absl::SimpleAtod(*value, &spoken.factor)) spoken.factor = 0;
  } else if (kind == "way" || kind == "compass" || kind == "compass side") {
    spoken.way = *meanings.ways.Find(tokens, span);
  } else if (kind == "hand") {
    spoken.way = *meanings.hands.Find(tokens, span);
  } else if (kind == "angle") {
    spoken.angle_deg = AngleIn(tokens, span);
  } else if (kind == "away") {
    spoken.is_away = true;
  } else if (kind == "target" || kind == "opening") {
    spoken.target = FindTarget(tokens, span).value_or(Target());
    spoken.is_away = spoken.is_away || slot == "target:away";
  }
}

std::optional<Spoken> SpokenReader::ReadForm(std::string_view text, const Tokens& tokens, Span span) {
  const std::optional<Form> form =
      Forms::Get().Match(tokens, span, [&](const std::string& slot, Span in) { return Fits(tokens, slot, in); });
  if (!form.has_value()) return std::nullopt;
  Spoken spoken{.act = form->act, .said = TextOf(text, tokens, span)};
  for (const auto& [slot, in] : form->slots) {
    Fill(tokens, slot, in, spoken);
    if (slot == "place") spoken.place = TextOf(text, tokens, in);
  }
  // "A plant in the corner" is another one.
  if (spoken.what.is_new && spoken.act == "place") return std::nullopt;
  return spoken;
}

std::optional<Spoken> SpokenReader::ReadEdit(std::string_view text, const Tokens& tokens, Span span) {
  const size_t polite = WithoutPolite(tokens, span);
  std::vector<size_t> begins = {span.begin};
  if (polite > span.begin && polite < span.end) begins.push_back(polite);
  for (const size_t end : EndsOf(tokens, span)) {
    for (const size_t begin : begins) {
      std::optional<Spoken> spoken = ReadForm(text, tokens, {begin, end});
      if (spoken.has_value()) return spoken;
    }
  }
  return std::nullopt;
}

Spoken SpokenReader::Read(std::string_view text, const Tokens& tokens, Span span, Span& rest) {
  meant_.clear();
  is_lenient_ = false;
  rest = {span.end, span.end};
  const bool is_first = span.begin == 0 && !is_later_;
  if (!is_first && IsReason(tokens, span)) {
    for (const size_t join : JoinsIn(tokens, span)) {
      if (BeginsEdit(tokens, {join + 1, span.end})) rest.begin = join + 1;
    }
    return {.act = "reason", .said = TextOf(text, tokens, {span.begin, rest.begin})};
  }
  if (std::optional<Spoken> whole = ReadEdit(text, tokens, span)) return *std::move(whole);
  const std::vector<size_t> joins = JoinsIn(tokens, span);
  for (const size_t join : joins) {
    std::optional<Spoken> first = ReadEdit(text, tokens, {span.begin, join});
    if (!first.has_value()) continue;
    rest.begin = join + 1;
    return *std::move(first);
  }
  // What is no edit ends before one.
  Span clause = span;
  for (const size_t join : joins) {
    if (BeginsEdit(tokens, {join + 1, span.end})) clause.end = join;
    // "Two more chairs and a bigger table".
    const std::optional<Spoken> next = ReadEdit(text, tokens, {join + 1, span.end});
    if (next.has_value() && next->act.starts_with("resize")) clause.end = join;
  }
  if (clause.end < span.end) rest.begin = clause.end + 1;
  is_lenient_ = true;
  std::optional<Spoken> of_absent = ReadEdit(text, tokens, clause);
  const bool is_edit = of_absent.has_value() && !of_absent->absent.empty() && of_absent->act != "place";
  if (is_edit && (of_absent->act == "remove" || BeginsEdit(tokens, clause))) return *std::move(of_absent);
  const size_t begin = tokens[clause.begin].begin;
  // With what ends it.
  return {.said = clause.end == tokens.size() ? std::string(text.substr(begin)) : TextOf(text, tokens, clause)};
}

std::string HistoryAsked(std::string_view text) {
  static const std::vector<std::string> kAsked = {"undo", "redo", "another layout"};
  const v1::SolvedLayout nothing;
  const IdSet selected;
  const ObjectIds last;
  const FindPiece find = [](const std::string&) { return std::nullopt; };
  const MeantPieces pieces(nothing, selected, last, find);
  const Tokens tokens = PlainTokens(text);
  if (tokens.empty()) return "";
  Span rest;
  const Spoken spoken = SpokenReader(pieces, Room()).Read(text, tokens, {0, tokens.size()}, rest);
  const bool is_history = rest.empty() && std::ranges::find(kAsked, spoken.act) != kAsked.end();
  return is_history ? spoken.act : "";
}

}  // namespace flair::session
