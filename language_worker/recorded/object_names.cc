// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>
#include <utility>

#include "absl/strings/ascii.h"
#include "english/language.h"
#include "english/words.h"
#include "language_worker/recorded/recorded_text.h"
#include "llm/answers/read_answer.h"

namespace flair::language {
namespace {

// Words of the longest name that is looked for in a text.
constexpr size_t kLongestName = 6;

bool IsWordByte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || absl::ascii_isdigit(c) ||
         (static_cast<unsigned char>(c) & 0x80) != 0;
}

// Whether the word is a figure: "2", "0.5m".
bool IsFigure(const Word& word) { return absl::ascii_isdigit(word.key[0]); }

bool IsIn(const char* list, const Word& word) { return english::Language::Get().IsIn(list, word.key); }

// The two lengths of " (1.5m x 0.6m)", " - Width: 0.5m, Length: 0.4m" and the like, which must follow at once.
std::optional<std::pair<double, double>> ReadSize(std::string_view behind) {
  constexpr size_t kNear = 60;
  std::vector<double> sizes;
  for (const Word& word : ReadWords(behind.substr(0, std::min({behind.size(), kNear, behind.find('\n')})))) {
    if (IsFigure(word)) sizes.push_back(std::strtod(word.key.c_str(), nullptr));
    if (sizes.size() == 2) return std::pair(sizes[0], sizes[1]);
    if (!IsFigure(word) && !IsIn("size words", word)) break;
  }
  return std::nullopt;
}

// The 2 of " 2 - ..." or " (2)"; 0 when no bare number follows at once.
int ReadNumber(std::string_view behind) {
  constexpr size_t kNear = 20;
  const std::vector<Word> words = ReadWords(behind.substr(0, kNear));
  if (words.empty() || behind.find_first_not_of(" (#") != words.front().begin) return 0;
  const std::string& key = words.front().key;
  return key.size() < 3 && std::ranges::all_of(key, absl::ascii_isdigit) ? std::atoi(key.c_str()) : 0;
}

constexpr size_t kLongest = 390;

bool EndsSentence(std::string_view line, size_t at) {
  if (line[at] != '.' && line[at] != '!' && line[at] != '?') return false;
  if (at + 2 >= line.size() || line[at + 1] != ' ') return false;
  const char next = line[at + 2];
  if (next < 'A' || next > 'Z') return false;
  // "e.g. Wooden beams"
  return at < 2 || line[at - 2] != '.';
}

}  // namespace

std::vector<Word> ReadWords(std::string_view text) {
  std::vector<Word> words;
  for (size_t i = 0; i < text.size();) {
    if (!IsWordByte(text[i])) {
      ++i;
      continue;
    }
    Word word{i, i, ""};
    for (; i < text.size(); ++i) {
      const bool point = text[i] == '.' && i + 1 < text.size() && absl::ascii_isdigit(text[i + 1]) &&
                         !word.key.empty() && absl::ascii_isdigit(text[i - 1]);
      if (!IsWordByte(text[i]) && !point) break;
      word.key += absl::ascii_tolower(text[i]);
    }
    word.end = i;
    word.key = english::Singular(word.key);
    words.push_back(std::move(word));
  }
  return words;
}

std::string NameKey(std::string_view name) {
  std::string key;
  for (const Word& word : ReadWords(name)) {
    // A number at the end only tells equal things apart.
    if (key.empty() || !std::ranges::all_of(word.key, absl::ascii_isdigit)) key += word.key;
  }
  return key;
}

ObjectNames::ObjectNames(const std::vector<const v1::Object*>& objects) : objects_(objects) {
  for (size_t i = 0; i < objects.size(); ++i) {
    Name name;
    name.key = NameKey(objects[i]->name());
    for (Word& word : ReadWords(objects[i]->name())) name.words.push_back(std::move(word.key));
    const auto same = std::ranges::find_if(names_, [&](const Name& n) { return n.key == name.key; });
    Name& known = same != names_.end() ? *same : names_.emplace_back(std::move(name));
    known.objects.push_back(static_cast<int>(i));
  }
}

std::vector<int> ObjectNames::Choose(std::string_view behind, std::string_view zone_id,
                                     std::vector<int> objects) const {
  if (objects.size() < 2) return objects;
  const auto keep = [&](auto right) {
    std::vector<int> kept;
    std::copy_if(objects.begin(), objects.end(), std::back_inserter(kept), right);
    if (!kept.empty()) objects = std::move(kept);
  };
  if (const auto size = ReadSize(behind)) {
    const auto equal = [](double a, double b) { return std::abs(a - b) < 0.005; };
    keep([&](int i) {
      const v1::Object& object = *objects_[static_cast<size_t>(i)];
      return (equal(object.width_m(), size->first) && equal(object.depth_m(), size->second)) ||
             (equal(object.width_m(), size->second) && equal(object.depth_m(), size->first));
    });
  }
  if (!zone_id.empty()) keep([&](int i) { return objects_[static_cast<size_t>(i)]->zone_id() == zone_id; });
  const int number = ReadNumber(behind);
  if (number >= 1 && number <= static_cast<int>(objects.size())) return {objects[static_cast<size_t>(number - 1)]};
  return objects;
}

std::vector<Mention> ObjectNames::Find(std::string_view text, std::string_view zone_id) const {
  const std::vector<Word> words = ReadWords(text);
  std::vector<Mention> mentions;
  for (size_t i = 0; i < words.size();) {
    size_t taken = 0;
    for (size_t count = std::min(kLongestName, words.size() - i); count > 0 && taken == 0; --count) {
      std::string key;
      for (size_t k = i; k < i + count; ++k) key += words[k].key;
      for (const Name& name : names_) {
        if (name.key.empty() || name.key != key) continue;
        const size_t end = words[i + count - 1].end;
        mentions.push_back({words[i].begin, end, Choose(text.substr(end), zone_id, name.objects)});
        taken = count;
        break;
      }
    }
    i += std::max<size_t>(taken, 1);
  }
  return mentions;
}

std::vector<Mention> ObjectNames::FindLoosely(std::string_view text, std::string_view zone_id) const {
  std::vector<Mention> mentions = Find(text, zone_id);
  if (!mentions.empty()) return mentions;
  for (const Word& word : ReadWords(text)) {
    constexpr size_t kLeast = 3;  // "of", "tv"
    if (word.key.size() < kLeast) continue;
    const Name* only = nullptr;
    int count = 0;
    for (const Name& name : names_) {
      if (std::ranges::find(name.words, word.key) == name.words.end()) continue;
      only = &name;
      ++count;
    }
    if (count != 1) continue;
    const bool known =
        std::ranges::any_of(mentions, [&](const Mention& other) { return other.objects == only->objects; });
    if (!known) mentions.push_back({word.begin, word.end, Choose(text.substr(word.end), zone_id, only->objects)});
  }
  return mentions;
}

std::string FindZone(std::string_view text, const std::vector<std::string>& zone_ids) {
  const std::vector<Word> words = ReadWords(text);
  for (const std::string& id : zone_ids) {
    // "living_area" is one word of an id but two of a text.
    std::string key;
    for (size_t i = 0; i < std::min<size_t>(words.size(), 3); ++i) {
      key += words[i].key;
      if (key == NameKey(id)) return id;
    }
  }
  return "";
}

std::vector<std::string> SplitSentences(std::string_view line) {
  std::vector<std::string> sentences;
  size_t begin = 0;
  int open = 0;
  const auto add = [&](size_t end) {
    std::string_view sentence = line.substr(begin, end - begin);
    const size_t first = sentence.find_first_not_of(' ');
    if (first != std::string_view::npos) {
      sentences.push_back(llm::CutBytes(llm::ToUtf8(sentence.substr(first)), kLongest));
    }
    begin = end;
  };
  for (size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '(') ++open;
    if (line[i] == ')') open = std::max(0, open - 1);
    if (open == 0 && EndsSentence(line, i)) add(i + 1);
  }
  add(line.size());
  return sentences;
}

bool IsSize(std::string_view text) {
  const std::vector<Word> words = ReadWords(text);
  return std::ranges::all_of(words, [](const Word& word) { return IsFigure(word) || IsIn("size words", word); });
}

bool HasSize(std::string_view text) {
  const std::vector<Word> words = ReadWords(text);
  return std::ranges::any_of(words, [](const Word& word) { return IsFigure(word) && word.key.back() == 'm'; });
}

bool HasWordOf(const char* list, std::string_view text) {
  const std::vector<Word> words = ReadWords(text);
  return std::ranges::any_of(words, [&](const Word& word) { return IsIn(list, word); });
}

double Likeness(std::string_view a, std::string_view b) {
  const auto keys = [](std::string_view text) {
    std::set<std::string, std::less<>> set;
    for (Word& word : ReadWords(text)) {
      if (!IsIn("empty words", word)) set.insert(std::move(word.key));
    }
    return set;
  };
  const auto first = keys(a), second = keys(b);
  const size_t least = std::min(first.size(), second.size());
  if (least == 0) return 0;
  const auto common = std::ranges::count_if(first, [&](const auto& word) { return second.contains(word); });
  return static_cast<double>(common) / static_cast<double>(least);
}

}  // namespace flair::language
