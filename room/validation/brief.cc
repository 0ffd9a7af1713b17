// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "room/validation/checks.h"

namespace flair::validation {
namespace {

constexpr int kLongestBrief = 4000;
constexpr double kSeedEnd = 9007199254740992.0;  // 2^53

std::string_view Trimmed(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t\r\n\v\f");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n\v\f") - first + 1);
}

// Byte of the first control character (C0, DEL), or npos.
size_t FindControlCharacter(std::string_view text) {
  const auto found = std::find_if(text.begin(), text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7F;
  });
  return found == text.end() ? std::string_view::npos : static_cast<size_t>(found - text.begin());
}

// Whether a letter of any script is in it. Counts two- and three-byte characters outside the symbol blocks U+2000 to
// U+2BFF and U+FE00 to U+FE0F as letters, four-byte ones (emoji) not.
bool HasLetter(std::string_view text) {
  for (size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= 0xC3 && c < 0xE0)) return true;
    if (c < 0xE0 || c >= 0xF0 || i + 1 >= text.size()) continue;
    const auto next = static_cast<unsigned char>(text[i + 1]);
    const bool symbol = (c == 0xE2 && next >= 0x80 && next < 0xB0) || (c == 0xEF && next == 0xB8);
    if (!symbol) return true;
  }
  return false;
}

}  // namespace

void Check(const v1::Brief& brief, const Field& at) {
  const Field text = at["text"];
  const std::string_view trimmed = Trimmed(brief.text());
  if (trimmed.empty()) {
    text.Reject("is empty; say what room you want, such as \"A bedroom that is 4m x 5m.\"");
  } else if (text.Text(trimmed, 1, kLongestBrief)) {
    const size_t control = FindControlCharacter(trimmed);
    if (control != std::string_view::npos) {
      text.Reject("has the control character 0x{:02x} at byte {}; plain text only",
                  static_cast<unsigned char>(trimmed[control]), control);
    } else if (!HasLetter(trimmed)) {
      text.Reject("\"{}\" has no word; say what room you want, such as \"A bedroom that is 4m x 5m.\"", trimmed);
    }
  }
  at["seed"].InRange(static_cast<double>(brief.seed()), {.least = 0, .most = kSeedEnd, .open_most = true});
  if (brief.has_room()) Check(brief.room(), at["room"]);
  if (brief.has_zone_plan()) Check(brief.zone_plan(), at["zone_plan"]);
  const NameSet zones = ZoneIds(brief.zone_plan()), objects = ObjectIds(brief.object_list());
  if (brief.has_object_list()) {
    Check(brief.object_list(), {.zones = brief.has_zone_plan() ? &zones : nullptr}, at["object_list"]);
  }
  if (brief.has_constraint_list()) {
    Check(brief.constraint_list(), {.objects = brief.has_object_list() ? &objects : nullptr}, at["constraint_list"]);
  }
}

}  // namespace flair::validation
