// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/choices.h"

#include <set>
#include <utility>

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
  const std::string bare = Bare(text);
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

}  // namespace flair::llm
