// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/brief_facts.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "language_worker/handbook/reading/unknown_things.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {
namespace {

constexpr int kMostPeople = 40;

// One way to say something, and what is then meant.
template <typename T>
struct Saying {
  Phrase phrase;
  const T* meaning;
};

template <typename T>
void AddSayings(const std::string& name, const google::protobuf::RepeatedPtrField<std::string>& others,
                const T& meaning, std::vector<Saying<T>>& sayings) {
  if (!name.empty()) sayings.push_back({Phrase(name), &meaning});
  for (const std::string& other : others) sayings.push_back({Phrase(other), &meaning});
}

// The longest saying that begins at a token; of equally long ones the first.
template <typename T>
std::pair<const T*, std::size_t> LongestAt(const std::vector<Saying<T>>& sayings, const std::vector<Token>& tokens,
                                           std::size_t i, bool plural) {
  std::pair<const T*, std::size_t> best = {nullptr, 0};
  for (const Saying<T>& saying : sayings) {
    const std::size_t length = saying.phrase.MatchAt(tokens, i, plural);
    if (length > best.second) best = {saying.meaning, length};
  }
  return best;
}

template <typename T>
void AddOnce(std::vector<const T*>& list, const T* item) {
  if (std::find(list.begin(), list.end(), item) == list.end()) list.push_back(item);
}

// Reads one brief; each step marks the tokens that it has used, so that "dining room" wishes for no dining table and
// "green room" for no greenhouse.
class BriefReader {
 public:
  BriefReader(const Handbook& handbook, std::string_view text) : handbook_(handbook), tokens_(Tokenize(text)) {
    used_.resize(tokens_.size());
  }

  absl::StatusOr<BriefFacts> Read() {
    absl::StatusOr<SizeRequest> size = ReadSize(tokens_, handbook_.contents());
    if (!size.ok()) return size.status();
    facts_.size = *size;
    ReadArchetype();
    ReadFurniture();
    ReadThemesAndStyles();
    ReadNeeds();
    facts_.reads_as_english = facts_.archetype_named || ReadsAsEnglish(tokens_);
    if (facts_.reads_as_english) facts_.not_known = UnknownThings(tokens_, used_);
    return std::move(facts_);
  }

 private:
  void Use(std::size_t start, std::size_t length) {
    std::fill_n(used_.begin() + static_cast<std::ptrdiff_t>(start), length, true);
  }

  void UseAll(std::string_view phrase) {
    const Phrase words(phrase);
    for (std::size_t i = 0; i < tokens_.size(); ++i) Use(i, words.MatchAt(tokens_, i));
  }

  void ReadArchetype() {
    std::vector<Saying<hb::Archetype>> names;
    for (const hb::Archetype& archetype : handbook_.contents().archetypes()) {
      if (!archetype.fallback()) AddSayings(archetype.name(), archetype.synonyms(), archetype, names);
    }
    std::size_t best_length = 0, best_start = 0;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const auto [archetype, length] = LongestAt(names, tokens_, i, /*plural=*/false);
      if (length <= best_length) continue;
      best_length = length;
      best_start = i;
      facts_.archetype = archetype;
    }
    facts_.archetype_named = facts_.archetype != nullptr;
    if (facts_.archetype_named) {
      Use(best_start, best_length);
    } else {
      GuessArchetype();
    }
  }

  // The kind of room that most words of the brief hint at.
  void GuessArchetype() {
    facts_.archetype = &handbook_.fallback_archetype();
    int most = 0;
    for (const hb::Archetype& archetype : handbook_.contents().archetypes()) {
      int hints = 0;
      for (const std::string& hint : archetype.hints()) hints += Phrase(hint).Occurs(tokens_) ? 1 : 0;
      if (hints > most) {
        most = hints;
        facts_.archetype = &archetype;
      }
    }
  }

  void ReadFurniture() {
    std::vector<Saying<hb::Furniture>> names;
    for (const hb::Furniture& furniture : handbook_.contents().furniture()) {
      AddSayings(furniture.name(), furniture.synonyms(), furniture, names);
    }
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (used_[i]) continue;
      const auto [furniture, length] = LongestAt(names, tokens_, i, /*plural=*/true);
      if (length == 0) continue;
      if (IsRefused(i)) {
        AddOnce(facts_.refusals, furniture);
      } else {
        const int seats = furniture->companions().empty() ? 0 : SeatsAfter(i + length);
        AddWish(*furniture, CountBefore(i), seats);
        if (seats > 0) Use(i + length, 2);  // these are the table's, not the room's
        TakeColourBefore(i, *furniture);
      }
      Use(i, length);
      i += length - 1;
    }
  }

  std::vector<Saying<hb::NamedColour>> ColourSayings() const {
    std::vector<Saying<hb::NamedColour>> colours;
    for (const hb::NamedColour& colour : handbook_.contents().colours()) {
      AddSayings(colour.name(), colour.synonyms(), colour, colours);
    }
    return colours;
  }

  // "a green armchair", "two sage green velvet armchairs": the colour is the piece's, not the room's.
  void TakeColourBefore(std::size_t i, const hb::Furniture& furniture) {
    const std::vector<Saying<hb::NamedColour>> colours = ColourSayings();
    for (std::size_t back = 3; back >= 1; --back) {
      if (back > i || used_[i - back]) continue;
      const auto [colour, length] = LongestAt(colours, tokens_, i - back, /*plural=*/false);
      if (length == 0 || length > back) continue;
      for (std::size_t k = i - back + length; k < i; ++k) {
        if (tokens_[k].kind != Token::Kind::kWord || tokens_[k].text == "and" || tokens_[k].text == "with") return;
      }
      facts_.object_colours.emplace_back(&furniture, colour);
      Use(i - back, length);
      return;
    }
  }

  void AddWish(const hb::Furniture& furniture, int count, int seats) {
    if (count > kMostOfAKind) {
      AddOnce(facts_.too_many, &furniture);
      count = kMostOfAKind;
    }
    for (Wish& wish : facts_.wishes) {
      if (wish.furniture != &furniture) continue;
      wish.count = std::max(wish.count, count);
      wish.seats = std::max(wish.seats, seats);
      return;
    }
    facts_.wishes.push_back({&furniture, count, seats});
  }

  // Of "a table for eight", "a table for 8 people": eight. 0 when nothing of the kind stands there.
  int SeatsAfter(std::size_t i) const {
    if (i + 1 >= tokens_.size() || tokens_[i].text != "for") return 0;
    const Token& token = tokens_[i + 1];
    if (token.text == "a" || token.text == "an") return 0;
    const int number = token.kind == Token::Kind::kNumber ? static_cast<int>(std::min(token.number, 1e6))
                                                          : NumberWord(token.text).value_or(0);
    const bool ends = i + 2 == tokens_.size() || tokens_[i + 2].kind == Token::Kind::kSign ||
                      CountsPeople(tokens_[i + 2].text) || tokens_[i + 2].text == "and" ||
                      tokens_[i + 2].text == "with";
    return ends && number <= kMostPeople ? number : 0;
  }

  // "no tv", "without a desk", "no tv or desk".
  bool IsRefused(std::size_t i) const {
    for (std::size_t back = 1; back <= 4 && back <= i; ++back) {
      const std::string& word = tokens_[i - back].text;
      if (word == "no" || word == "without" || word == "not") return true;
      if (word == "," || word == "." || word == ";" || word == "with" || word == "but" || word == "and") return false;
    }
    return false;
  }

  // The number said before a noun, looking back over adjectives: "two comfortable armchairs", "2 x desk", "a pair of".
  int CountBefore(std::size_t i) const {
    for (std::size_t back = 1; back <= 3 && back <= i; ++back) {
      const std::size_t at = i - back;
      const Token& token = tokens_[at];
      if (token.kind == Token::Kind::kNumber) {
        const double number = std::min(token.number, 1e6);
        return number >= 1 && number == std::floor(number) ? static_cast<int>(number) : 1;
      }
      for (const hb::CountWord& word : handbook_.contents().count_words()) {
        for (const std::string& text : word.words()) {
          const std::size_t length = Phrase(text).MatchAt(tokens_, at, false);
          if (length > 0 && at + length <= i && word.count() > 0) return word.count();
        }
      }
      if (const std::optional<int> number = NumberWord(token.text)) {
        // "a pair of": the article belongs to the pair, which stands after it.
        return *number;
      }
      if (token.kind == Token::Kind::kSign && token.text != "-") break;
      if (token.text == "and" || token.text == "with") break;
    }
    return 1;
  }

  void ReadThemesAndStyles() {
    for (const hb::Theme& theme : handbook_.contents().themes()) {
      if (!theme.fallback() && OccursUnused(theme.keywords())) AddOnce(facts_.themes, &theme);
    }
    for (const hb::Style& style : handbook_.contents().styles()) {
      if (Phrase(style.name()).Occurs(tokens_)) AddOnce(facts_.styles, &style);
    }
    const std::vector<Saying<hb::NamedColour>> colours = ColourSayings();
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const auto [colour, length] = LongestAt(colours, tokens_, i, /*plural=*/false);
      if (length == 0 || used_[i]) continue;
      AddOnce(facts_.colours, colour);
      Use(i, length);
      i += length - 1;
    }
    for (const hb::Theme* theme : facts_.themes) {
      for (const std::string& keyword : theme->keywords()) UseAll(keyword);
    }
    for (const hb::Style* style : facts_.styles) UseAll(style->name());
  }

  void ReadNeeds() {
    std::vector<const hb::Need*> found;
    for (const hb::Need& need : handbook_.contents().needs()) {
      int people = 0;
      if (!Applies(need, people)) continue;
      found.push_back(&need);
      if (people > 0) facts_.people = people;
    }
    if (!facts_.people) ReadPeople();
    for (const hb::Need* need : found) {
      const bool overridden = std::any_of(found.begin(), found.end(), [&](const hb::Need* other) {
        return std::find(other->overrides().begin(), other->overrides().end(), need->name()) !=
               other->overrides().end();
      });
      if (!overridden) facts_.needs.push_back(need);
    }
    for (const hb::Need* need : found) {
      for (const std::string& keyword : need->keywords()) UseAll(keyword);
    }
  }

  // "for 6", "for six guests": a number after "for" that ends a phrase or counts people.
  void ReadPeople() {
    for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
      if (tokens_[i].text != "for" || used_[i]) continue;
      const Token& token = tokens_[i + 1];
      const std::optional<int> named = token.text == "a" || token.text == "an" ? std::nullopt : NumberWord(token.text);
      const int number =
          token.kind == Token::Kind::kNumber ? static_cast<int>(std::min(token.number, 1e6)) : named.value_or(0);
      const bool ends = i + 2 == tokens_.size() || tokens_[i + 2].kind == Token::Kind::kSign;
      if (number < 1 || number > kMostPeople || !(ends || CountsPeople(tokens_[i + 2].text))) continue;
      facts_.people = number;
      return;
    }
  }

  bool Applies(const hb::Need& need, int& people) const {
    const auto& rooms = need.condition().rooms();
    if (!rooms.empty() && std::find(rooms.begin(), rooms.end(), facts_.archetype->name()) == rooms.end()) return false;
    if (!need.also_keywords().empty() && !OccursAny(need.also_keywords())) return false;
    for (const std::string& keyword : need.keywords()) {
      int number = 0;
      if (!OccursFree(Phrase(keyword), number)) continue;
      if (number > 0 && need.min_people() > 0 && number < need.min_people()) continue;
      if (number > 0 && need.max_people() > 0 && number > need.max_people()) continue;
      people = number;
      return true;
    }
    return false;
  }

  // Whether it occurs without a number that belongs to something else.
  bool OccursFree(const Phrase& phrase, int& number) const {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      int found = 0;
      const std::size_t length = phrase.MatchAt(tokens_, i, true, &found);
      if (length == 0 || (found > 0 && used_[i])) continue;
      number = found;
      return true;
    }
    return false;
  }

  // As OccursAny, but not within words that name the room or its furniture: a king bed makes no king.
  bool OccursUnused(const google::protobuf::RepeatedPtrField<std::string>& phrases) const {
    for (const std::string& text : phrases) {
      const Phrase phrase(text);
      for (std::size_t i = 0; i < tokens_.size(); ++i) {
        const std::size_t length = phrase.MatchAt(tokens_, i);
        for (std::size_t k = i; k < i + length; ++k) {
          if (!used_[k]) return true;
        }
      }
    }
    return false;
  }

  bool OccursAny(const google::protobuf::RepeatedPtrField<std::string>& phrases) const {
    return std::any_of(phrases.begin(), phrases.end(),
                       [&](const std::string& phrase) { return Phrase(phrase).Occurs(tokens_); });
  }

  const Handbook& handbook_;
  const std::vector<Token> tokens_;
  std::vector<bool> used_;
  BriefFacts facts_;
};

}  // namespace

absl::StatusOr<BriefFacts> ReadBrief(const v1::Brief& brief, const Handbook& handbook) {
  return BriefReader(handbook, brief.text()).Read();
}

}  // namespace flair::language
