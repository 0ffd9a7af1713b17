// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/mention_list.h"

namespace flair::language {

MentionList::MentionList(const std::vector<Token>& tokens, const std::vector<Mention>& mentions)
    : text_(tokens), mentions_(mentions), at_(tokens.size(), mentions.size()) {
  for (std::size_t m = 0; m < mentions.size(); ++m) {
    for (std::size_t i = mentions[m].begin; i < mentions[m].end; ++i) at_[i] = m;
  }
}

std::optional<std::size_t> MentionList::At(std::size_t token) const {
  return token < at_.size() && at_[token] < mentions_.size() ? std::optional(at_[token]) : std::nullopt;
}

std::optional<std::size_t> MentionList::From(std::size_t token) const {
  constexpr std::size_t kMostBetween = 6;
  for (std::size_t i = token; i < text_.size() && i < token + kMostBetween; ++i) {
    if (At(i)) return At(i);
    if (!Describes(i)) break;
  }
  return std::nullopt;
}

bool MentionList::AreListed(std::size_t first, std::size_t second) const {
  constexpr std::size_t kMostBetween = 7;
  const std::size_t begin = mentions_[first].end, end = mentions_[second].begin;
  if (end <= begin || end - begin > kMostBetween) return false;
  bool joined = false;
  for (std::size_t i = begin; i < end; ++i) {
    const bool joint = text_.Says(i, {",", "and"});
    joined = joined || joint;
    if (!joint && !Describes(i)) return false;
  }
  return joined;
}

std::optional<std::size_t> MentionList::HolderOf(std::size_t held) const {
  std::size_t first = held;
  while (first > 0 && AreListed(first - 1, first)) --first;
  if (first == 0) return std::nullopt;
  bool with = false;
  for (std::size_t i = mentions_[first - 1].end; i < mentions_[first].begin; ++i) {
    with = with || text_.At(i) == "with";
    if (text_.At(i) != "with" && !Describes(i)) return std::nullopt;
  }
  return with ? std::optional(first - 1) : std::nullopt;
}

// Whether a token may stand before the noun of a piece.
bool MentionList::Describes(std::size_t token) const {
  if (text_.IsHyphen(token) || text_.Is(token, "thing_articles") || NumberWord(text_.At(token))) return true;
  return !text_.IsSign(token) && !text_.Is(token, "thing_ends");
}

}  // namespace flair::language
