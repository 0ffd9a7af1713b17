// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/choices.h"

#include <algorithm>
#include <set>
#include <utility>

#include "llm/answers/utf8.h"

namespace flair::llm {
namespace {

// The names whose bare form `equal` accepts, aliases included.
template <typename Equal>
std::set<std::string> Meant(const Choices& choices, const Equal& equal) {
  std::set<std::string> meant;
  for (const std::string& name : choices.names) {
    if (equal(Bare(name))) meant.insert(name);
  }
  for (const auto& [alias, name] : choices.aliases) {
    if (equal(Bare(alias))) meant.insert(name);
  }
  return meant;
}

std::string WithoutPlural(std::string text) {
  if (text.size() > 3 && text.back() == 's') text.pop_back();
  return text;
}

// Its words in lower case and in the singular.
std::set<std::string> WordsOf(std::string_view written) {
  const std::string text = PlainMarks(written);
  std::set<std::string> words;
  std::string word;
  for (size_t i = 0; i <= text.size(); ++i) {
    const std::string bare = i < text.size() ? Bare(std::string_view(text).substr(i, 1)) : "";
    word += bare;
    if (bare.empty() && !word.empty()) words.insert(WithoutPlural(std::exchange(word, {})));
  }
  return words;
}

}  // namespace

std::string Bare(std::string_view text) {
  std::string bare;
  for (const char c : text) {
    if (c >= 'A' && c <= 'Z') {
      bare += static_cast<char>(c - 'A' + 'a');
    } else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80) {
      bare += c;
    }
  }
  return bare;
}

std::optional<std::string> FindChoice(std::string_view text, const Choices& choices) {
  const std::string bare = Bare(PlainMarks(text));
  if (bare.empty()) return std::nullopt;
  for (const std::string& name : choices.names) {
    if (name == text) return name;
  }
  std::set<std::string> meant = Meant(choices, [&](const std::string& name) { return name == bare; });
  if (meant.empty()) {
    const std::string singular = WithoutPlural(bare);
    meant = Meant(choices, [&](const std::string& name) { return WithoutPlural(name) == singular; });
  }
  if (meant.size() != 1) return std::nullopt;
  return *meant.begin();
}

std::optional<std::string> FindChoiceWithin(std::string_view text, const Choices& choices) {
  const std::set<std::string> words = WordsOf(text);
  if (words.empty()) return std::nullopt;
  std::set<std::string> held, holding;
  size_t most = 0;
  const auto compare = [&](const std::string& written, const std::string& name) {
    const std::set<std::string> own = WordsOf(written);
    if (own.empty()) return;
    if (std::ranges::includes(words, own) && own.size() >= most) {
      if (own.size() > most) held.clear();
      most = own.size();
      held.insert(name);
    } else if (std::ranges::includes(own, words)) {
      holding.insert(name);
    }
  };
  for (const std::string& name : choices.names) compare(name, name);
  for (const auto& [alias, name] : choices.aliases) compare(alias, name);
  const std::set<std::string>& meant = held.empty() ? holding : held;
  return meant.size() == 1 ? std::optional(*meant.begin()) : std::nullopt;
}

}  // namespace flair::llm
