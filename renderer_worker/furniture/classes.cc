// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/furniture/classes.h"

#include <google/protobuf/text_format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <map>
#include <set>

#include "renderer_worker/furniture/furniture_text.h"

namespace flair::renderer {
namespace {

constexpr size_t kLongestPhrase = 3;
constexpr std::array<std::string_view, 7> kSmallWords = {"and", "for", "from", "in", "of", "on", "with"};

using Words = std::vector<std::string>;

// "boxes" becomes "box", "candles" "candle"; "glass" stays. The records' own words go the same way, so that "shelves"
// need not be right.
std::string Singular(const std::string& word) {
  const auto ends = [&word](std::string_view suffix) {
    return word.size() > suffix.size() + 1 && word.ends_with(suffix);
  };
  if (ends("ches") || ends("shes") || ends("xes") || ends("sses")) return word.substr(0, word.size() - 2);
  if (ends("s") && !ends("ss") && !ends("us")) return word.substr(0, word.size() - 1);
  return word;
}

// Up to the first comma or bracket; lower case and singular.
Words WordsOf(std::string_view text) {
  Words words;
  std::string word;
  const auto finish = [&] {
    if (!word.empty()) words.push_back(Singular(word));
    word.clear();
  };
  for (const char c : text.substr(0, 200)) {
    if (c == ',' || c == ';' || c == '(' || c == '[') break;
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalpha(byte) != 0 || byte >= 0x80) {
      word += static_cast<char>(std::tolower(byte));
    } else {
      finish();
    }
  }
  finish();
  return words;
}

std::string Joined(std::span<const std::string> words, std::string_view between) {
  std::string text;
  for (const std::string& word : words) text.append(text.empty() ? "" : between).append(word);
  return text;
}

// What is looked up in the records.
class Vocabulary {
 public:
  Vocabulary() {
    for (const FurnitureClass& each : Furniture().furniture()) {
      by_name_.emplace(each.name(), &each);
      for (const std::string& phrase : each.words()) {
        const Words words = WordsOf(phrase);
        nouns_.emplace(Joined(words, " "), each.name());
        nouns_.emplace(Joined(words, ""), each.name());  // "desklamp"
      }
      for (const std::string& noun : each.words_alone()) nouns_alone_.emplace(Singular(noun), each.name());
    }
    const FurnitureData& data = Furniture();
    plain_.insert(data.plain_adjective().begin(), data.plain_adjective().end());
    for (const FurnitureMaterial& material : data.material()) {
      plain_.insert(material.name());
      plain_.insert(material.words().begin(), material.words().end());
    }
    collective_.insert(data.collective().begin(), data.collective().end());
  }

  const FurnitureClass* Named(std::string_view name) const {
    const auto at = by_name_.find(name);
    return at != by_name_.end() ? at->second : nullptr;
  }

  std::string_view ClassOfName(const Words& words) const {
    const std::span<const std::string> all(words);
    size_t end = 0;
    while (end < words.size() && !IsSmall(words[end])) ++end;
    // "chest of drawers", "vanity with sink".
    for (size_t start = 0; end < words.size() && start < end; ++start) {
      const size_t length = std::min(kLongestPhrase, words.size() - start);
      if (start + length <= end) continue;
      if (const std::string_view found = Find(nouns_, Joined(all.subspan(start, length), " ")); !found.empty()) {
        return found;
      }
    }
    // "stack of books".
    if (end > 0 && end < words.size() && collective_.contains(words[end - 1])) {
      return ClassOfName(Words(words.begin() + static_cast<ptrdiff_t>(end) + 1, words.end()));
    }
    return ClassOfHead(all.first(end));
  }

 private:
  using Nouns = std::map<std::string, std::string_view, std::less<>>;

  static bool IsSmall(std::string_view word) { return std::ranges::find(kSmallWords, word) != kSmallWords.end(); }

  static std::string_view Find(const Nouns& nouns, const std::string& phrase) {
    const auto at = nouns.find(phrase);
    return at != nouns.end() ? at->second : std::string_view();
  }

  std::string_view ClassOfHead(std::span<const std::string> words) const {
    std::string_view found = ClassOfEnd(words);
    while (found.empty() && words.size() > 1 && (words.back().size() == 1 || collective_.contains(words.back()))) {
      words = words.first(words.size() - 1);
      found = ClassOfEnd(words);
    }
    return found;
  }

  std::string_view ClassOfEnd(std::span<const std::string> words) const {
    for (size_t length = std::min(kLongestPhrase, words.size()); length > 0; --length) {
      if (const std::string_view found = Find(nouns_, Joined(words.last(length), " ")); !found.empty()) return found;
    }
    if (words.empty()) return {};
    const auto before = words.first(words.size() - 1);
    const bool plain = std::ranges::all_of(before, [this](const auto& w) { return plain_.contains(w); });
    return plain ? Find(nouns_alone_, words.back()) : std::string_view();
  }

  std::map<std::string_view, const FurnitureClass*> by_name_;
  Nouns nouns_;
  Nouns nouns_alone_;
  std::set<std::string, std::less<>> plain_;
  std::set<std::string, std::less<>> collective_;
};

const Vocabulary& OurVocabulary() {
  static const Vocabulary& vocabulary = *new Vocabulary();
  return vocabulary;
}

// The class that a category or an id names; empty for one that is too rough to trust.
std::string_view ClassOfLabel(const std::string& label) {
  const FurnitureClass* found = OurVocabulary().Named(label);
  if (found == nullptr) found = OurVocabulary().Named(ClassFromWords(label));
  return found != nullptr && !found->rough() ? std::string_view(found->name()) : std::string_view();
}

// The same words mean other things on the floor, on furniture, on walls and above.
std::string_view WhereItIs(const FurnitureClass& found, const v1::Object& object) {
  const auto either = [&](const std::string& other) { return std::string_view(other.empty() ? found.name() : other); };
  switch (object.kind()) {
    case v1::OBJECT_KIND_CEILING:
      return either(found.on_ceiling());
    case v1::OBJECT_KIND_WALL:
      return either(found.on_wall());
    case v1::OBJECT_KIND_SURFACE:
      if (found.is_host()) {
        const std::string_view thing = ClassFromWords(object.name().substr(0, object.name().find_last_of(' ')));
        if (!thing.empty() && thing != found.name()) return WhereItIs(ClassNamed(thing), object);
      }
      return either(found.on_surface());
    default:
      if (!found.wide_on_floor().empty() && object.width_m() > 1.4 * object.depth_m()) return found.wide_on_floor();
      return either(found.on_floor());
  }
}

}  // namespace

const FurnitureData& Furniture() {
  static const FurnitureData& data = [] -> const FurnitureData& {
    auto* read = new FurnitureData();
    for (const char* text : {kClassesText, kMaterialsText}) {
      FurnitureData part;
      if (!google::protobuf::TextFormat::ParseFromString(text, &part)) std::abort();  // a test reads them
      read->MergeFrom(part);
    }
    return *read;
  }();
  return data;
}

const FurnitureClass& ClassNamed(std::string_view class_name) {
  const FurnitureClass* found = OurVocabulary().Named(class_name);
  return found != nullptr ? *found : *OurVocabulary().Named("box");
}

int ClassIdOf(std::string_view class_name) {
  const FurnitureClass* found = OurVocabulary().Named(class_name);
  return found != nullptr ? found->id() : 0;
}

std::string_view ClassFromWords(std::string_view name) { return OurVocabulary().ClassOfName(WordsOf(name)); }

std::string_view ClassOf(const v1::Object& object) {
  std::string_view found = ClassFromWords(object.name());
  // A category may say more: "mushroom table", a round_table.
  const bool refines = !found.empty() && object.category().ends_with("_" + std::string(found));
  if (refines && ClassIdOf(object.category()) > 0) found = object.category();
  if (found.empty()) found = ClassOfLabel(object.category());
  if (found.empty()) found = ClassOfLabel(object.id());
  if (found.empty()) return object.walk_over() ? ClassNamed("rug").name() : ClassNamed("box").name();
  return WhereItIs(ClassNamed(found), object);
}

float RestHeightOf(std::string_view class_name, float height_m) {
  for (const RestHeight& rest : ClassNamed(class_name).rest()) {
    if (height_m <= rest.taller_than_m()) continue;
    float height = rest.share() > 0 ? rest.share() * height_m : height_m;
    if (rest.most_m() > 0) height = std::min(rest.most_m(), height);
    if (rest.below_top_m() > 0) height = std::max(height, height_m - rest.below_top_m());
    return height;
  }
  return height_m;
}

}  // namespace flair::renderer
