// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/furniture_index.h"

#include <array>
#include <set>

namespace flair::language {
namespace {

// "shelves" and "desks" to "shelf" and "desk": the forms to try for the last word, best first.
std::array<std::string, 4> Singulars(const std::string& name) {
  std::array<std::string, 4> forms = {name, "", "", ""};
  const auto ends = [&](std::string_view ending) { return name.size() > ending.size() + 2 && name.ends_with(ending); };
  if (ends("ves")) forms[1] = name.substr(0, name.size() - 3) + "f";
  if (ends("ies")) forms[1] = name.substr(0, name.size() - 3) + "y";
  if (ends("es")) forms[2] = name.substr(0, name.size() - 2);
  if (ends("s")) forms[3] = name.substr(0, name.size() - 1);
  return forms;
}

}  // namespace

FurnitureIndex::FurnitureIndex(const Handbook& handbook) {
  // Names before synonyms: a word may be one class's name and another's synonym.
  for (const hb::Furniture& furniture : handbook.contents().furniture()) {
    by_word_.emplace(PlainName(furniture.name()), &furniture);
  }
  for (const hb::Furniture& furniture : handbook.contents().furniture()) {
    for (const std::string& synonym : furniture.synonyms()) by_word_.emplace(PlainName(synonym), &furniture);
  }
}

const hb::Furniture* FurnitureIndex::FindExact(std::string_view name) const {
  for (const std::string& form : Singulars(PlainName(name))) {
    if (form.empty()) continue;
    if (const auto found = by_word_.find(form); found != by_word_.end()) return found->second;
  }
  return nullptr;
}

const hb::Furniture* FurnitureIndex::Find(std::string_view name) const {
  std::string words = PlainName(name);
  while (!words.empty()) {
    if (const hb::Furniture* found = FindExact(words)) return found;
    const size_t space = words.find(' ');
    if (space == std::string::npos) break;
    words = words.substr(space + 1);
  }
  return nullptr;
}

bool IsRugName(std::string_view name) {
  static const std::set<std::string, std::less<>> kRugs = {"rug",  "rugs",   "carpet",    "carpets", "mat",
                                                           "mats", "runner", "sheepskin", "doormat", "tatami"};
  const std::string words = PlainName(name);
  const size_t space = words.rfind(' ');
  const std::string last = space == std::string::npos ? words : words.substr(space + 1);
  // A table runner lies on a table, a place mat too.
  if (words.starts_with("table ") || words.starts_with("place ") || words.starts_with("desk ")) return false;
  return kRugs.contains(last);
}

std::string PlainName(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    const bool upper = c >= 'A' && c <= 'Z';
    const bool word =
        upper || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
    if (word) {
      plain += upper ? static_cast<char>(c - 'A' + 'a') : c;
    } else if (!plain.empty() && plain.back() != ' ') {
      plain += ' ';
    }
  }
  if (!plain.empty() && plain.back() == ' ') plain.pop_back();
  return plain;
}

}  // namespace flair::language
