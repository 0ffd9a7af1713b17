// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/news.h"

#include <algorithm>

namespace flair::orchestrator {

namespace {

// The first letter of what is sent, by NewsKind.
constexpr std::string_view kLetters = "wjhb";
static_assert(static_cast<size_t>(NewsKind::kUnknown) == kLetters.size());

}  // namespace

std::string WriteNews(const News& news) {
  return std::string(1, kLetters.at(static_cast<size_t>(news.kind))) + ' ' + news.subject + ' ' + news.batch_id;
}

News ReadNews(std::string_view text) {
  if (text.size() < 2 || text[1] != ' ') return {};
  News news;
  news.kind = static_cast<NewsKind>(std::min(kLetters.find(text[0]), kLetters.size()));
  text.remove_prefix(2);
  const size_t space = text.find(' ');
  news.subject = text.substr(0, space);
  if (space != std::string_view::npos) news.batch_id = text.substr(space + 1);
  return news;
}

}  // namespace flair::orchestrator
