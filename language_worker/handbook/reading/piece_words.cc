// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/piece_words.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "english/quantities.h"
#include "english/words.h"
#include "language_worker/handbook/reading/meanings.h"
#include "language_worker/handbook/reading/other_words.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {

namespace {

// "6", "six"; 0 for articles and other words.
int CountAt(const BriefText& text, std::size_t i) {
  constexpr double kMost = 1e6;
  if (text.Says(i, {"a", "an", "the"})) return 0;
  return text.IsNumber(i) ? static_cast<int>(std::clamp(std::ceil(text.NumberAt(i)), 0.0, kMost))
                          : NumberWord(text.At(i)).value_or(0);
}

// "three-seat", "2 seater", "six-drawer", "ten-foot", "65-inch", "2 m long": how large a piece is, not how many of it.
bool MeasuresThePiece(const BriefText& text, std::size_t i) {
  return CountAt(text, i) > 0 && text.Is(text.IsHyphen(i + 1) ? i + 2 : i + 1, "piece_measures");
}

// "A 180 bed", "a 1.80 bed": centimetres or metres, of one.
bool MeasuresOnePiece(const BriefText& text, std::size_t at, std::size_t end) {
  const double number = text.NumberAt(at);
  return (number >= kLeastCm || number != std::floor(number)) && !text.At(end - 1).ends_with('s');
}

// "..., five of them", "(4)", "x 2"; 0 where nothing of the kind follows.
int CountBehind(const BriefText& text, std::size_t end) {
  const bool bracket = text.At(end) == "(", times = text.At(end) == "x";
  const int number = bracket || times || text.Says(end, {",", ":", "-"}) ? CountAt(text, end + 1) : 0;
  const bool closes = bracket ? text.At(end + 2) == ")" : times || text.BehindPhrase(end + 2, "of_those_before");
  return number > 0 && closes && (!times || number <= 100) && !text.Is(end + 2, "unit_words") ? number : 0;
}

// "Everything except a bath", "all the usual things but no bath".
bool IsOfEverything(const BriefText& text, std::size_t except) {
  constexpr std::size_t kMostBack = 8;
  for (std::size_t at = except; at > 0 && except - at < kMostBack && !text.EndsSentence(at - 1); --at) {
    if (text.Is(at - 1, "everything")) return true;
  }
  return false;
}

}  // namespace

bool AsksForFew(const BriefText& text, std::size_t i) {
  constexpr std::size_t kMostBack = 4;
  for (std::size_t back = 1; back <= kMostBack && back <= i; ++back) {
    const std::size_t at = i - back;
    if (text.IsSign(at) || text.Says(at, {"and", "with"})) return false;
    const bool some = at > 0 && text.Says(at - 1, {"a", "quite"});
    if (const auto end = text.BehindPhrase(at, "few_phrases"); end && *end <= i && !some) return true;
  }
  return false;
}

bool SaysMany(const BriefText& text, std::size_t i) {
  constexpr std::size_t kMostBack = 6;
  for (std::size_t at = i; at > 0 && at + kMostBack > i && (text.IsWord(at - 1) || text.IsHyphen(at - 1)); --at) {
    if (const auto end = text.BehindPhrase(at - 1, "many_of_them"); end && *end <= i) return !AsksForFew(text, i);
  }
  return false;
}

int SensibleNumber(const hb::Furniture& furniture, double area_m2) {
  constexpr double kForEachM2 = 5, kSmallM2 = 0.21;
  constexpr int kFewest = 3;
  if (furniture.kind() == hb::FURNITURE_KIND_SURFACE) return kFewest;
  const bool large = furniture.width_m().typical() * furniture.depth_m().typical() > kSmallM2;
  if (!IsFloorPiece(furniture) || PlacesOn(furniture) > 0 || large) return kMostSmallThings;
  return std::clamp(static_cast<int>(area_m2 / kForEachM2), kFewest, kMostSmallThings);
}

std::optional<std::size_t> PhraseBefore(std::string_view list, const BriefText& text, std::size_t i) {
  constexpr std::size_t kMostBack = 7;
  for (std::size_t at = i; at > 0 && at + kMostBack > i; --at) {
    if (text.IsSign(at - 1) && !text.IsHyphen(at - 1)) break;
    if (text.Is(at - 1, "thing_articles") || text.Says(at - 1, {"the", "and", "with"})) break;
    if (const auto end = text.BehindPhrase(at - 1, list); end && *end <= i) return at - 1;
  }
  return std::nullopt;
}

bool IsFurther(const BriefText& text, std::size_t i) {
  std::size_t begin = text.PhraseBegin(i);
  // "A seventh, bigger chair".
  if (begin > 1 && text.At(begin - 1) == "," && text.Is(begin - 2, "further_ones")) return true;
  for (std::size_t at = i; at-- > begin;) {
    if (text.Is(at, "further_ones")) return true;
  }
  return false;
}

bool IsMeasure(const BriefText& text, std::size_t i) {
  return i >= 2 && text.IsHyphen(i - 1) && text.tokens()[i].glued && MeasuresThePiece(text, i - 2);
}

bool CountsSeveral(const BriefText& text, std::size_t i) {
  constexpr int kSeveral = 4;
  for (std::size_t at = text.PhraseBegin(i); at < i; ++at) {
    if (CountAt(text, at) >= kSeveral && !MeasuresThePiece(text, at)) return true;
  }
  return false;
}

bool SeatsFollow(const BriefText& text, std::size_t i) {
  if (SeatsAround(text, i, 0).end > i) return true;
  const bool seats = MatchesWord(text.At(i + 2), "chair") || MatchesWord(text.At(i + 2), "seat");
  if (text.At(i) == "with" && CountAt(text, i + 1) > 0 && seats) return true;
  // "With benches", "and two long benches", ", benches down both sides".
  constexpr std::size_t kMostWords = 4;
  std::size_t at = i + 1;
  while (text.Says(i, {"with", "and", ","}) && at < i + kMostWords && text.IsWord(at) && !text.Is(at, "joined") &&
         !IsFormIn("seats_at_tables", text.At(at)))
    ++at;
  return text.Says(i, {"with", "and", ","}) && IsFormIn("seats_at_tables", text.At(at));
}

SeatsSaid SeatsAround(const BriefText& text, std::size_t i, std::size_t length) {
  const std::size_t end = i + length;
  if (const auto behind = text.BehindPhrase(end, "before_seats")) {
    const std::size_t at = text.Is(*behind, "articles") ? *behind + 1 : *behind;
    const int number = CountAt(text, at);
    // What may follow: "for six by the window". A number with another behind it is a size.
    const bool ends = at + 1 >= text.size() || text.IsSign(at + 1) || CountsPeople(text.At(at + 1)) ||
                      (text.Is(at + 1, "after_seats") && !(text.At(at + 1) == "by" && text.IsNumber(at + 2)));
    if (number > 0 && number <= kMostSeats && ends) return {number, end, at + 1};
  }
  if (length == 0) return {};
  const std::size_t begin = text.PhraseBegin(i);
  for (std::size_t at = begin; at < i; ++at) {
    const std::size_t noun = text.IsHyphen(at + 1) ? at + 2 : at + 1;
    if (CountAt(text, at) > 0 && noun < i && text.Is(noun, "seats_of_a_piece"))
      return {CountAt(text, at), at, noun + 1};
  }
  // "Two to a desk", "two pupils at each table".
  const std::size_t each = begin > 0 && text.Is(begin - 1, "each_words") ? begin - 1 : begin;
  if (each > 1 && text.Is(each - 1, "at_each_piece")) {
    const bool per = text.At(each - 1) == "per";
    std::size_t at = each - 2;
    while (at > 0 && CountAt(text, at) == 0 && text.IsWord(at) && CountsPeople(text.At(at))) --at;
    const bool said = each < begin || per || text.Says(each, {"a", "an"});
    if (CountAt(text, at) > 0 && said && (at < each - 2 || per || text.At(each - 1) == "to"))
      return {CountAt(text, at), at, each, true};
  }
  // "That'll sit ten round one long table."
  if (begin < 2 || !text.Is(begin - 1, "around_a_table")) return {};
  const std::size_t at = begin > 2 && IsFormIn("persons", text.At(begin - 2)) ? begin - 3 : begin - 2;
  const bool people = at < begin - 2 || (at > 0 && text.Is(at - 1, "holds_people"));
  return people && CountAt(text, at) > 0 ? SeatsSaid{CountAt(text, at), at, begin} : SeatsSaid();
}

Groups GroupsAround(const BriefText& text, std::size_t i, std::size_t length) {
  constexpr std::size_t kMostBehind = 8, kMostBack = 8, kMostWords = 4;
  constexpr int kMost = 100, kFewest = 2;
  const auto number = [&](std::size_t k) { return std::min(CountAt(text, k), kMost); };
  const auto in_pairs = [&](std::size_t k) {
    return text.At(k) == "pairs" && k > 0 && (text.Says(k - 1, {"in", "into"}) || number(k - 1) > 0);
  };
  const auto is_group = [&](std::size_t k) { return IsFormIn("groups_of_pieces", text.At(k)) || in_pairs(k); };
  // Four columns of three are three rows of four.
  const auto turned = [&](Groups groups, std::size_t group) {
    if (!IsFormIn("columns_of_pieces", text.At(group))) return groups;
    groups.rows = true;
    std::swap(groups.count, groups.in_each);
    return groups;
  };
  const std::size_t end = i + length;
  for (std::size_t at = end; at < end + kMostBehind && !text.EndsSentence(at) && !text.Says(at, {"and", "with"});
       ++at) {
    if (!text.Says(at, {"in", "into"})) continue;
    std::size_t group = at + (number(at + 1) > 0 ? 2 : 1);
    while (group < at + kMostWords && !is_group(group) && text.IsWord(group) && !text.Is(group, "thing_articles"))
      ++group;
    if (!is_group(group) || number(at + 1) == 1 || (number(at + 1) == 0 && !text.At(group).ends_with('s'))) continue;
    Groups groups{number(at + 1), 0, at, group + 1, IsFormIn("rows_of_pieces", text.At(group))};
    if (in_pairs(group)) groups.in_each = 2, groups.rows = true;
    if (text.At(group + 1) == "of" && number(group + 2) > 0) groups.in_each = number(group + 2), groups.end = group + 3;
    return turned(groups, group);
  }
  for (std::size_t at = i; at > 0 && at + kMostBack > i && text.PhraseBegin(i) <= at; --at) {
    const std::size_t group = at - 1;
    if (!is_group(group) || text.At(at) != "of") continue;
    // "In clusters of four": so many as it takes.
    const int fewest = text.At(group).ends_with('s') && number(at + 1) > 0 ? 0 : 1;
    Groups groups{std::max(fewest, number(group - std::min<std::size_t>(group, 1))), number(at + 1), group, i,
                  IsFormIn("rows_of_pieces", text.At(group))};
    // "Two rows of recliners, four each".
    for (std::size_t k = end; k < end + kMostWords && groups.in_each == 0; ++k) {
      for (std::size_t each = k + 1; each < k + kMostWords && number(k) > 0; ++each) {
        if (text.Says(each, {"each", "per"})) groups.in_each = number(k);
      }
    }
    groups.in_each = std::max(groups.in_each, kFewest);
    if (number(group - std::min<std::size_t>(group, 1)) > 0) --groups.begin;
    return turned(groups, group);
  }
  return {};
}

PieceCount CountOf(const Handbook& handbook, const BriefText& text, const hb::Furniture& furniture, std::size_t i,
                   std::size_t length) {
  if (AsksForFew(text, i)) return {1};
  for (std::size_t at = i, begin = text.PhraseBegin(i); at-- > begin;) {
    // "Somewhere for forty pairs of shoes" is one piece.
    if (text.At(at) == "pairs" && at > begin && CountAt(text, at - 1) > 2) return {1};
    if (MeasuresThePiece(text, at) && (text.IsHyphen(at + 1) ? at + 2 : at + 1) < i) continue;
    if (text.IsNumber(at) && MeasuresOnePiece(text, at, i + length)) continue;
    if (text.IsNumber(at)) {
      const double number = std::min(text.NumberAt(at), 1e6);
      return {number >= 1 && number == std::floor(number) ? static_cast<int>(number) : 1};
    }
    // "A few" is more than "a".
    std::pair<std::size_t, int> longest = {0, 0};
    for (const hb::CountWord& word : handbook.contents().count_words()) {
      for (const std::string& words : word.words()) {
        const std::size_t said = Phrase(words).MatchAt(text.tokens(), at, false);
        if (said > longest.first && at + said <= i && word.count() > 0) longest = {said, word.count()};
      }
    }
    if (longest.first > 0) return {longest.second};
    // "a pair of": the article belongs to the pair, which stands after it.
    // "Half a dozen", of which the last word is one by itself.
    for (std::size_t k = at - std::min<std::size_t>(at, 2); k < at; ++k) {
      const auto whole = text.At(at) == "dozen" ? english::NumberAt(text.tokens(), k) : std::nullopt;
      if (whole && whole->end == at + 1) return {static_cast<int>(whole->value)};
    }
    if (const std::optional<int> number = NumberWord(text.At(at))) return {*number};
  }
  if (const int behind = CountBehind(text, i + length); behind > 0) return {behind};
  constexpr int kEverywhere = 6;
  if (text.BehindPhrase(i + length, "everywhere")) return {kEverywhere, false};
  const std::string_view last = text.At(i + length - 1);
  const bool plural = furniture.plural() != furniture.name() && last.ends_with('s') && !last.ends_with("ss") &&
                      LongestAt(handbook.vocabulary().names, text.tokens(), i, /*plural=*/false).second < length;
  // "Shelving along both walls" is said in no number.
  const bool mass = text.Is(i + length - 1, "mass_nouns") && !text.Is(text.PhraseBegin(i), "articles");
  return plural ? PieceCount{2, false} : PieceCount{1, !mass};
}

std::string LastWord(const std::string& name) { return name.substr(name.rfind(' ') + 1); }

bool RefuseKind(const Handbook& handbook, const BriefText& text, std::size_t i, std::size_t length, BriefFacts& facts) {
  if (IsFormIn("openings", text.At(i)) || IsFormIn("wall_nouns", text.At(i))) return false;
  bool any = false;
  for (const Vocabulary::Head& head : handbook.vocabulary().heads) {
    if (std::ranges::none_of(head.words, [&](const Phrase& word) { return word.MatchAt(text.tokens(), i) == length; }))
      continue;
    // "No small tables" is not said of the table to eat at, "no overhead light" of all that hang.
    for (const hb::Furniture* option : head.options) {
      if (length == 1 || !IsFloorPiece(*option)) AddOnce(facts.refusals, option);
    }
    any = true;
  }
  if (length > 1) return any;
  const std::string kind = text.At(i) == "lighting" ? "lamp" : english::Singular(text.At(i));
  const bool of_furniture =
      std::ranges::any_of(handbook.contents().furniture(), [&](const auto& one) { return one.category() == kind; });
  for (const hb::Furniture& other : handbook.contents().furniture()) {
    const std::string last = LastWord(other.name());
    // Planters and bonsai are plants too.
    // Ceiling lamps are lamps, an armchair is a chair, a settee a sofa.
    const std::string category = other.category().substr(other.category().rfind('_') + 1);
    const bool same = Phrase(last).MatchAt(text.tokens(), i) == 1 || MatchesWord(kind, category);
    const bool compound = of_furniture && last.size() > kind.size() + 1 && last.ends_with(kind);
    if (!same && !compound && (IsIn("kinds_of_their_own", last) || !IsKindOf(other.name(), kind))) continue;
    AddOnce(facts.refusals, &other);
    any = true;
  }
  return any;
}

bool IsLikened(const BriefText& text, std::size_t i) {
  const std::size_t begin = text.PhraseBegin(i);
  return begin > 1 && text.At(begin - 1) == "like" && text.Is(begin - 2, "before_likeness");
}

bool IsRefused(const BriefText& text, std::size_t i) {
  // "Please leave the rug out", "washing machine not in here".
  constexpr std::size_t kMostBehind = 3;
  for (std::size_t at = i + 1; at <= i + kMostBehind && at < text.size() && !text.EndsSentence(at); ++at) {
    if (text.BehindPhrase(at, "refused_behind")) return true;
    if (text.At(at) == "out" && i >= 1 && (text.At(i - 1) == "leave" || (i >= 2 && text.At(i - 2) == "leave")))
      return true;
    if (text.IsSign(at) && !text.IsHyphen(at)) break;
  }
  for (const std::size_t back : {1, 2, 3, 4, 5}) {
    if (back <= i && text.BehindPhrase(i - back, "refused_before").value_or(0) >= i - back + 2) return true;
  }
  // "Without a wardrobe or a dresser".
  std::size_t most = 4;
  for (std::size_t back = 1; back <= most && back <= i; ++back) {
    const std::size_t at = i - back;
    if (text.Says(at, {"or", "nor"})) most += 3;
    const std::string_view before = back < i ? text.At(at - 1) : std::string_view();
    if (text.Is(at, "exceptions") || text.At(at) == "but") return IsOfEverything(text, at);
    if (text.Is(at, "place_prepositions")) return false;
    if ((text.At(at) == "of" && before == "instead") || (text.At(at) == "than" && before == "rather")) return true;
    if (text.At(at) == "than") return false;
    if (text.Is(at, "refusing")) return !text.Says(at + 1, {"only", "just"});
    if (text.Says(at, {",", ".", ";", "with", "and"})) return false;
  }
  return false;
}

bool IsOptional(const BriefText& text, const std::vector<bool>& used, std::size_t begin, std::size_t end) {
  constexpr std::size_t kMostWords = 8, kMostBefore = 5;
  for (std::size_t at = end; at < text.size() && at < end + kMostWords; ++at) {
    if (text.BehindPhrase(at, "optional_behind")) return true;
    const bool comma = text.At(at) == "," && text.BehindPhrase(at + 1, "optional_behind");
    if ((text.IsSign(at) && !comma && text.At(at) != "(") || text.Says(at, {"and", "with"})) break;
  }
  for (std::size_t back = 1; back <= kMostBefore && back <= begin; ++back) {
    const std::size_t at = begin - back;
    if (text.BehindPhrase(at, "optional_before")) return true;
    // "Space for maybe 300 records, a piano."
    const bool pause = text.At(at) == "," && (at == 0 || text.BehindPhrase(at - 1, "optional_before") != at);
    if (pause || (text.IsSign(at) && text.At(at) != ",") || text.Says(at, {"and", "with", "is"}) || used[at]) break;
  }
  return false;
}

bool AsksForNothingElse(const Handbook& handbook, const BriefText& text) {
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    const bool negated = i > 0 && text.Says(i - 1, {"not", "if"});
    const bool counts = NumberWord(text.At(i + 1)) || text.At(i + 1) == "the" || text.IsNumber(i + 1);
    if (text.Says(i, {"only", "just"}) && !negated && counts) {
      // "only 3 m wide", "only one window": of the room.
      for (std::size_t k = i + 2; k < std::min(i + 5, text.size()); ++k) {
        if (LongestAt(handbook.vocabulary().names, text.tokens(), k, /*plural=*/true).second > 0) return true;
        if (text.IsSign(k) || text.Says(k, {"with", "for"})) break;
      }
    }
    if (text.BehindPhrase(i, "nothing_else_phrases")) return true;
  }
  return false;
}

bool IsFloorPiece(const hb::Furniture& furniture) {
  return !furniture.walk_over() &&
         (furniture.kind() == hb::FURNITURE_KIND_FLOOR || furniture.kind() == hb::FURNITURE_KIND_UNSPECIFIED);
}

int PlacesOn(const hb::Furniture& furniture) {
  constexpr double kOnABenchM = 0.5, kOnASofaM = 0.6, kCornerM = 0.9, kTwoInABedM = 1.3;
  const std::string& category = furniture.category();
  const double width_m = furniture.width_m().typical();
  if (category == "bench") return std::max(1, static_cast<int>(width_m / kOnABenchM));
  if (category == "sofa") return std::max(1, static_cast<int>(width_m / kOnASofaM));
  if (category == "corner_sofa") {
    return std::max(1, static_cast<int>((width_m + furniture.depth_m().typical() - kCornerM) / kOnASofaM));
  }
  if (category == "bed" || category == "bunk_bed")
    return width_m >= kTwoInABedM || furniture.name() == "bunk bed" ? 2 : 1;
  if (category == "crib" || category == "cot") return 1;
  return category == "chair" || category == "stool" || category == "armchair" ? 1 : 0;
}

bool IsSeat(const hb::Furniture& furniture) {
  return furniture.category() == "chair" || furniture.category() == "stool";
}

const hb::Furniture* SeatOf(const hb::Furniture& furniture, const Handbook& handbook) {
  for (const hb::ObjectEntry& companion : furniture.companions()) {
    const hb::Furniture* seat = handbook.FindFurniture(companion.furniture());
    if (seat != nullptr && (IsSeat(*seat) || seat->category() == "bench")) return seat;
  }
  return nullptr;
}

const hb::Furniture* SeatOfTheRoom(const hb::Archetype& room, const Handbook& handbook) {
  const hb::Furniture* seat = handbook.FindFurniture(room.per_person());
  for (const hb::Band& band : room.bands()) {
    for (const hb::ObjectEntry& entry : band.objects()) {
      const hb::Furniture* host = handbook.FindFurniture(entry.furniture());
      if (host != nullptr && SeatOf(*host, handbook) == seat) return nullptr;  // it comes with its table
    }
  }
  return seat != nullptr && (IsSeat(*seat) || seat->category() == "armchair") ? seat : nullptr;
}

bool StandsWith(const hb::Furniture& furniture, const hb::Furniture& partner) {
  const auto names = [&](const auto& list) { return Includes(list, partner.name()); };
  return names(furniture.hosts()) ||
         std::ranges::any_of(furniture.relations(), [&](const hb::Relation& one) { return names(one.targets()); });
}

}  // namespace flair::language
