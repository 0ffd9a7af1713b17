// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/furniture/classes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <string>
#include <vector>

namespace flair::renderer {
namespace {

struct Class {
  std::string_view name;
  int id;
};

#define CLASS(name, id) {name, id},
constexpr Class kClasses[] = {
#include "renderer_worker/furniture/class_list.inc"
};
#undef CLASS

constexpr auto kClassNames = [] {
  std::array<std::string_view, std::size(kClasses)> names;
  for (size_t i = 0; i < names.size(); ++i) names[i] = kClasses[i].name;
  return names;
}();

struct Phrase {
  std::string_view words;
  std::string_view class_name;
};

#define WORDS(words, class_name) {words, class_name},
constexpr Phrase kPhrases[] = {
#include "renderer_worker/furniture/class_words.inc"
};
#undef WORDS

constexpr size_t kLongestPhrase = 3;

std::string_view Lookup(std::string_view words) {
  for (const Phrase& phrase : kPhrases) {
    if (phrase.words == words) return phrase.class_name;
  }
  return {};
}

// "shelves" stays (it is in the list), "boxes" becomes "box", "candles" "candle"; "glass" stays.
std::string Singular(const std::string& word) {
  const auto ends = [&word](std::string_view suffix) {
    return word.size() > suffix.size() + 1 && word.ends_with(suffix);
  };
  if (ends("ches") || ends("shes") || ends("xes") || ends("sses")) return word.substr(0, word.size() - 2);
  if (ends("s") && !ends("ss") && !ends("us")) return word.substr(0, word.size() - 1);
  return word;
}

std::vector<std::string> WordsOf(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : text.substr(0, 200)) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalpha(byte) || byte >= 0x80) {
      words.back() += static_cast<char>(std::tolower(byte));
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

// Words written as one: "desklamp" ends in a lamp, "pictureframe" in a frame.
std::string_view LookupEnd(const std::string& word) {
  constexpr size_t kShortestEnd = 4, kShortestStart = 3;
  const std::string singular = Singular(word);
  for (size_t at = kShortestStart; at + kShortestEnd <= singular.size(); ++at) {
    const std::string_view found = Lookup(std::string_view(singular).substr(at));
    if (!found.empty()) return found;
  }
  return {};
}

std::string_view ClassOfWords(std::span<const std::string> words) {
  for (size_t end = words.size(); end > 0; --end) {
    for (size_t length = std::min(kLongestPhrase, end); length > 0; --length) {
      std::string phrase;
      for (size_t i = end - length; i < end; ++i) phrase += (phrase.empty() ? "" : " ") + words[i];
      std::string_view found = Lookup(phrase);
      if (found.empty()) found = Lookup(Singular(phrase));
      if (!found.empty()) return found;
    }
    if (const std::string_view found = LookupEnd(words[end - 1]); !found.empty()) return found;
  }
  return {};
}

bool IsLamp(std::string_view name) { return name == "floor_lamp" || name == "table_lamp" || name == "wall_lamp"; }

// The same words mean other things on the floor, on furniture, on walls and above.
std::string_view WhereItIs(std::string_view found, const v1::Object& object) {
  switch (object.kind()) {
    case v1::OBJECT_KIND_CEILING:
      return found.empty() || IsLamp(found) ? "pendant" : found;
    case v1::OBJECT_KIND_WALL:
      if (found == "coat_stand" || found == "garment_rack") return "rack";
      return IsLamp(found) ? "wall_lamp" : found.empty() ? "box" : found;
    case v1::OBJECT_KIND_SURFACE:
      // "lamp desk" is the lamp on the desk.
      if (found == "desk" || found == "table" || found == "dresser" || found == "bed") {
        const std::string name = object.name().substr(0, object.name().find_last_of(' '));
        if (const std::string_view thing = ClassFromWords(name); !thing.empty()) found = thing;
      }
      return IsLamp(found) ? "table_lamp" : found.empty() ? "box" : found;
    default:
      if (found == "wall_lamp") return "floor_lamp";
      if (found == "rack") return object.width_m() > 1.4 * object.depth_m() ? "garment_rack" : "coat_stand";
      return !found.empty() ? found : object.walk_over() ? "rug" : "box";
  }
}

}  // namespace

std::string_view ClassFromWords(std::string_view text) {
  const std::vector<std::string> words = WordsOf(text);
  if (words.size() == kLongestPhrase) {
    const std::string_view whole = Lookup(words[0] + " " + words[1] + " " + words[2]);
    if (!whole.empty()) return whole;
  }
  // "wardrobe with mirror": what comes before the first small word names the thing, unless it says nothing ("stack of
  // books") or the phrase goes on ("chest of drawers").
  for (size_t i = 1; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "of" && (words[i - 1] == "chest" || words[i - 1] == "suit")) continue;
    if (word != "of" && word != "with" && word != "for" && word != "on" && word != "in" && word != "and") continue;
    const std::string_view head = ClassOfWords(std::span(words).first(i));
    if (!head.empty()) return head;
  }
  return ClassOfWords(words);
}

std::span<const std::string_view> FurnitureClasses() { return kClassNames; }

int ClassIdOf(std::string_view class_name) {
  const auto at = std::lower_bound(std::begin(kClasses), std::end(kClasses), class_name,
                                   [](const Class& each, std::string_view name) { return each.name < name; });
  return at != std::end(kClasses) && at->name == class_name ? at->id : 0;
}

std::string_view ClassOf(const v1::Object& object) {
  // Names say more than categories: an office chair is a chair, a weight bench a bench.
  std::string_view found = ClassFromWords(object.name());
  // Unless the category is a kind of what the name says: "mushroom table", a round_table.
  const bool refines = !found.empty() && object.category().ends_with("_" + std::string(found));
  if ((found.empty() || refines) && ClassIdOf(object.category()) > 0) {
    found =
        kClassNames[std::lower_bound(kClassNames.begin(), kClassNames.end(), object.category()) - kClassNames.begin()];
  }
  if (found.empty()) found = ClassFromWords(object.category());
  if (found.empty()) found = ClassFromWords(object.id());
  return WhereItIs(found, object);
}

}  // namespace flair::renderer
