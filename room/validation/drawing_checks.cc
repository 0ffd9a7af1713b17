// SPDX-License-Identifier: GPL-3.0-or-later
// Plans in parts: a page takes their elements over as they are, so that they must do nothing but draw.
#include <algorithm>
#include <vector>

#include "room/validation/field.h"

namespace flair::validation {
namespace {

constexpr std::string_view kElements[] = {"circle", "ellipse", "g", "line", "path", "polygon", "polyline", "rect"};

// Takes characters while they are, or with `until` are not, among these.
std::string_view Take(std::string_view& text, std::string_view these, bool until = false) {
  const std::string_view taken = text.substr(0, until ? text.find_first_of(these) : text.find_first_not_of(these));
  text.remove_prefix(taken.size());
  return taken;
}

bool TakeWord(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

std::string_view TakeName(std::string_view& text) { return Take(text, "abcdefghijklmnopqrstuvwxyz123-"); }
void SkipSpace(std::string_view& text) { Take(text, " \t\r\n"); }

// Takes an attribute; false at one that does more than draw, or is none.
bool TakeAttribute(std::string_view& text) {
  const std::string_view name = TakeName(text);
  if (name.empty() || name.starts_with("on") || name == "id" || name == "href" || name == "style") return false;
  if (!TakeWord(text, "=\"")) return false;
  const std::string_view value = Take(text, "\"<", true);
  return value.find("url(") == std::string_view::npos && TakeWord(text, "\"");
}

// Takes a tag; false at one that must not be. `open` are the elements around it.
bool TakeTag(std::string_view& text, std::vector<std::string_view>& open) {
  if (TakeWord(text, "</")) {
    if (open.empty() || TakeName(text) != open.back()) return false;
    open.pop_back();
    return TakeWord(text, ">");
  }
  if (!TakeWord(text, "<")) return false;
  const std::string_view name = TakeName(text);
  if (std::ranges::find(kElements, name) == std::end(kElements)) return false;
  for (SkipSpace(text); !text.starts_with('/') && !text.starts_with('>'); SkipSpace(text)) {
    if (!TakeAttribute(text)) return false;
  }
  if (TakeWord(text, "/>")) return true;
  open.push_back(name);
  return TakeWord(text, ">");
}

void CheckDrawing(std::string_view svg, const Field& at) {
  std::vector<std::string_view> open;
  do {
    SkipSpace(svg);
    const std::string_view tag = svg.substr(0, 40);
    if (TakeTag(svg, open)) continue;
    at.Reject("\"{}\" is more than a drawing, or none; elements are {}, without id, href, style and handlers", tag,
              fmt::join(kElements, ", "));
    return;
  } while (!open.empty());
  SkipSpace(svg);
  if (!svg.empty()) at.Reject("is more than one element");
}

}  // namespace

void Check(const v1::PlanParts& parts, const Known&, const Field& at) {
  if (!parts.floor_svg().empty()) CheckDrawing(parts.floor_svg(), at["floor_svg"]);
  if (!parts.walls_svg().empty()) CheckDrawing(parts.walls_svg(), at["walls_svg"]);
  for (int i = 0; i < parts.parts_size(); ++i) {
    const v1::PlanPart& part = parts.parts(i);
    CheckDrawing(part.svg(), at["parts"][i]["svg"]);
    if (!part.shadow_svg().empty()) CheckDrawing(part.shadow_svg(), at["parts"][i]["shadow_svg"]);
  }
}

}  // namespace flair::validation
