// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/vocabulary.h"

#include <array>
#include <set>

#include "english/wordnet.h"
#include "english/words.h"

namespace flair::language {
namespace {

constexpr std::size_t kShortest = 5;
constexpr std::size_t kLongest = 24;  // words of that many letters are no English any more
constexpr std::size_t kMostCorrections = 20;

std::string FirstKey(std::string_view word) { return "<" + std::string(word.substr(0, 2)); }
std::string LastKey(std::string_view word) { return ">" + std::string(word.substr(word.size() - 2)); }

template <typename T, typename Others>
void AddSayings(const std::string& name, const Others& others, const T& meaning, std::vector<Saying<T>>& sayings) {
  if (!name.empty()) sayings.push_back({Phrase(name), &meaning});
  for (const std::string& other : others) sayings.push_back({Phrase(other), &meaning});
}

}  // namespace

bool IsOneEditAway(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  if (b.size() - a.size() > 1 || a == b) return false;
  std::size_t same = 0;
  while (same < a.size() && a[same] == b[same]) ++same;
  if (a.size() < b.size()) return a.substr(same) == b.substr(same + 1);
  if (a.substr(same + 1) == b.substr(same + 1)) return true;
  return same + 1 < a.size() && a[same] == b[same + 1] && a[same + 1] == b[same] &&
         a.substr(same + 2) == b.substr(same + 2);
}

Speller::Speller(const hb::Handbook& handbook) {
  const auto learn = [this](const auto& phrases, bool corrects) {
    for (const std::string& phrase : phrases) Learn(phrase, corrects);
  };
  for (const hb::Furniture& furniture : handbook.furniture()) {
    Learn(furniture.name(), !furniture.named_as_said());
    learn(furniture.synonyms(), !furniture.named_as_said());
  }
  for (const hb::Archetype& archetype : handbook.archetypes()) {
    Learn(archetype.name(), true);
    learn(archetype.synonyms(), true);
    learn(archetype.hints(), false);
  }
  for (const hb::NamedColour& colour : handbook.colours()) {
    Learn(colour.name(), true);
    learn(colour.synonyms(), true);
  }
  for (const hb::Noun& noun : handbook.nouns()) {
    learn(noun.words(), true);
    for (const hb::NounOption& option : noun.options()) learn(option.modifiers(), false);
  }
  for (const hb::Style& style : handbook.styles()) Learn(style.name(), true);
  for (const hb::Theme& theme : handbook.themes()) learn(theme.keywords(), false);
  for (const hb::SizeWord& size : handbook.size_words()) learn(size.words(), false);
  for (const hb::CountWord& count : handbook.count_words()) learn(count.words(), false);
  for (const hb::AskedPlace& place : handbook.asked_places()) learn(place.words(), false);
  learn(handbook.other_things(), false);
  learn(handbook.common_words(), false);
  for (const char* list : {"adjectives", "materials", "thing_ends", "not_pieces"}) learn(WordsOf(list), false);
}

void Speller::Learn(std::string_view phrase, bool corrects) {
  for (const Token& token : TokensOf(phrase)) {
    if (token.kind != Token::Kind::kWord) continue;
    const bool fresh = right_.insert(token.text).second;
    // Whatever follows is also right: "bunks", "painted".
    if (!corrects || token.text.size() < kShortest) continue;
    for (const std::string& form : {token.text, token.text + "s"}) {
      if (form != token.text) right_.insert(form);
      for (const std::string& key : {FirstKey(form), LastKey(form)}) {
        std::vector<std::string>& words = by_ends_[key];
        if (fresh || std::ranges::find(words, form) == words.end()) words.push_back(form);
      }
    }
  }
}

bool Speller::Knows(std::string_view word) const {
  if (IsRight(std::string(word)) || IsRight(english::Singular(word)) || IsRight(english::British(word))) return true;
  // Forms of words that are right: "painted", "lovely".
  constexpr std::array<std::string_view, 9> kEndings = {"es", "ed", "d", "ing", "ly", "er", "y", "n", "r"};
  return std::ranges::any_of(kEndings, [&](std::string_view ending) {
    return word.ends_with(ending) && IsRight(std::string(word.substr(0, word.size() - ending.size())));
  });
}

std::string Speller::MeantBy(std::string_view word) const {
  if (word.size() < kShortest || word.size() > kLongest || Knows(word)) return "";
  if (english::WordNet::Get().Knows(word)) return "";
  std::string meant;
  for (const std::string& key : {FirstKey(word), LastKey(word)}) {
    const auto words = by_ends_.find(key);
    if (words == by_ends_.end()) continue;
    for (const std::string& known : words->second) {
      if (known == meant || !IsOneEditAway(word, known)) continue;
      if (!meant.empty() && english::Singular(known) != english::Singular(meant)) return "";
      // Of "chair" and "chairs" that with as many letters.
      if (meant.empty() || known.size() == word.size()) meant = known;
    }
  }
  return meant;
}

std::vector<Correction> Speller::Correct(std::vector<Token>& tokens) const {
  std::vector<Correction> corrections;
  std::set<std::string> done;
  for (Token& token : tokens) {
    if (token.kind != Token::Kind::kWord || corrections.size() >= kMostCorrections) continue;
    std::string meant = MeantBy(token.text);
    if (meant.empty()) continue;
    if (done.insert(token.text).second) corrections.push_back({token.text, meant});
    token.text = std::move(meant);
  }
  return corrections;
}

namespace {

std::vector<PlaceWords> PlaceWordsOf(const hb::Handbook& handbook) {
  std::vector<PlaceWords> all;
  for (const hb::AskedPlace& asked : handbook.asked_places()) {
    const auto first = static_cast<std::ptrdiff_t>(all.size());
    for (const std::string& words : asked.words()) {
      const std::size_t brace = std::min(words.find('{'), words.size());
      const std::string slot = brace < words.size() ? words.substr(brace + 1, words.size() - brace - 2) : "";
      const std::size_t from = words.starts_with("not ") ? std::string_view("not ").size() : 0;
      const auto same = std::find_if(all.begin() + first, all.end(), [&](const PlaceWords& one) {
        return one.slot == slot && one.denied == (from > 0);
      });
      PlaceWords& place = same != all.end() ? *same : all.emplace_back(PlaceWords{&asked, slot, from > 0, {}});
      place.words.Add(std::string_view(words).substr(from, brace - from), 0);
    }
  }
  return all;
}

}  // namespace

Vocabulary::Vocabulary(const Handbook& handbook)
    : places(std::make_shared<const std::vector<PlaceWords>>(PlaceWordsOf(handbook.contents()))),
      speller(std::make_shared<const Speller>(handbook.contents())),
      meanings(std::make_shared<const Meanings>(handbook.contents())) {
  for (const hb::Noun& noun : handbook.contents().nouns()) {
    Head head{.noun = &noun, .words = {}, .options = {}, .modifiers = {}};
    for (const std::string& word : noun.words()) head.words.emplace_back(word);
    for (const hb::NounOption& option : noun.options()) {
      const hb::Furniture* furniture = handbook.FindFurniture(option.furniture());
      if (furniture == nullptr) continue;
      const bool only_modified = !option.modifiers().empty() && option.rooms().empty();
      if (!only_modified) AddSayings("", noun.words(), *furniture, names);
      head.options.push_back(furniture);
      for (const std::string& words : option.modifiers()) head.modifiers.push_back({Phrase(words), furniture});
    }
    if (!head.words.empty()) heads.push_back(std::move(head));
  }
  for (const hb::Furniture& furniture : handbook.contents().furniture()) {
    AddSayings(furniture.name(), furniture.synonyms(), furniture, names);
  }
  for (const hb::Archetype& archetype : handbook.contents().archetypes()) {
    if (!archetype.fallback()) AddSayings(archetype.name(), archetype.synonyms(), archetype, rooms);
  }
  // A "scribe's room" is the scribe's chamber, too, where that is no other kind of room.
  for (const hb::Archetype& archetype : handbook.contents().archetypes()) {
    for (const std::string& said : archetype.synonyms()) {
      constexpr std::string_view kRoom = "'s room";
      if (archetype.fallback() || !said.ends_with(kRoom)) continue;
      for (const std::string& noun : WordsOf("rooms_of_someone")) {
        const std::string other = said.substr(0, said.size() - kRoom.size() + 3) + noun;
        if (LongestAt(rooms, TokensOf(other), 0, false).second < TokensOf(other).size())
          rooms.push_back({Phrase(other), &archetype});
      }
    }
  }
  for (const hb::NamedColour& colour : handbook.contents().colours()) {
    AddSayings(colour.name(), colour.synonyms(), colour, colours);
  }
  for (const std::string& words : handbook.contents().other_things()) other_things.emplace_back(words);
  for (const hb::Furniture& furniture : handbook.contents().furniture()) {
    const std::size_t space = furniture.name().rfind(' ');
    if (space == std::string::npos) continue;
    const std::string last = furniture.name().substr(space + 1);
    const bool noun = std::ranges::any_of(heads, [&](const Head& head) { return Includes(head.noun->words(), last); });
    const hb::Furniture* other = noun ? nullptr : LongestAt(names, TokensOf(last), 0, /*plural=*/true).first;
    // A rack of any kind is none of these.
    if (other != nullptr && !other->name().ends_with(" " + last))
      short_names.push_back({Phrase(last), &furniture, other});
  }
}

Vocabulary::Vocabulary(const Vocabulary& base, const std::vector<hb::Furniture>& own) : Vocabulary(base) {
  std::vector<Saying<hb::Furniture>> all;
  for (const hb::Furniture& furniture : own) AddSayings(furniture.name(), furniture.synonyms(), furniture, all);
  all.insert(all.end(), names.begin(), names.end());
  names = std::move(all);
}

}  // namespace flair::language
