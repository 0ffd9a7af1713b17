// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "google/protobuf/repeated_ptr_field.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

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

// The longest saying that begins at a token; of equally long ones that which `rank` puts highest, then the first.
template <typename T, typename Rank>
std::pair<const T*, std::size_t> BestAt(const std::vector<Saying<T>>& sayings, const std::vector<Token>& tokens,
                                        std::size_t i, bool plural, const Rank& rank) {
  std::pair<const T*, std::size_t> best = {nullptr, 0};
  for (const Saying<T>& saying : sayings) {
    const std::size_t length = saying.phrase.MatchAt(tokens, i, plural);
    if (length == 0 || length < best.second) continue;
    if (length > best.second || rank(*saying.meaning) > rank(*best.first)) best = {saying.meaning, length};
  }
  return best;
}

template <typename T>
std::pair<const T*, std::size_t> LongestAt(const std::vector<Saying<T>>& sayings, const std::vector<Token>& tokens,
                                           std::size_t i, bool plural) {
  return BestAt(sayings, tokens, i, plural, [](const T&) { return 0; });
}

template <typename T>
void AddOnce(std::vector<const T*>& list, const T* item) {
  if (std::find(list.begin(), list.end(), item) == list.end()) list.push_back(item);
}

}  // namespace flair::language
