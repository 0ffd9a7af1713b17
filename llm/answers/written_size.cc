// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/written_size.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_replace.h"
#include "absl/strings/str_split.h"
#include "llm/answers/answer_members.h"
#include "llm/answers/choices.h"
#include "llm/answers/quantity.h"

namespace flair::llm {
namespace {

using google::protobuf::Descriptor;
using nlohmann::json;

// In the order in which they are written when nothing names them.
constexpr std::array<std::string_view, 3> kFields = {"width_m", "depth_m", "height_m"};
constexpr size_t kLongest = 120;

// One of the lengths of a size.
struct Part {
  std::string text;   // "1.6", "160 cm"
  size_t field = 3;   // of kFields; 3 when nothing names it
  bool unit = false;  // whether the text says its unit
};

struct SizeWord {
  std::string_view word;
  size_t field;
};
constexpr std::array kSizeWords = std::to_array<SizeWord>({
    {"width", 0},
    {"wide", 0},
    {"w", 0},
    {"depth", 1},
    {"deep", 1},
    {"length", 1},
    {"long", 1},
    {"d", 1},
    {"l", 1},
    {"height", 2},
    {"high", 2},
    {"tall", 2},
    {"h", 2},
});

bool IsLetter(char c) { return c >= 'a' && c <= 'z'; }

// The field that a word or letter names; 3 for none.
size_t FieldOf(std::string_view word) {
  const auto* const found = std::ranges::find(kSizeWords, word, &SizeWord::word);
  return found == kSizeWords.end() ? 3 : found->field;
}

std::string_view Stripped(std::string_view text) {
  constexpr std::string_view kSpace = " \t\n\r:=.";
  const size_t from = text.find_first_not_of(kSpace);
  if (from == std::string_view::npos) return {};
  const size_t to = text.find_last_not_of(" \t\n\r");
  return text.substr(from, to - from + 1);
}

// "W 1.6 m", "width: 1.6m", "1.6 m wide", "1.6w".
Part PartOf(std::string_view written) {
  std::string_view text = Stripped(written);
  Part part;
  size_t letters = 0;
  while (letters < text.size() && IsLetter(text[letters])) ++letters;
  if (letters > 0 && FieldOf(text.substr(0, letters)) < 3) {
    part.field = FieldOf(text.substr(0, letters));
    text = Stripped(text.substr(letters));
  }
  letters = 0;
  while (letters < text.size() && IsLetter(text[text.size() - 1 - letters])) ++letters;
  if (letters < text.size() && part.field == 3 && FieldOf(text.substr(text.size() - letters)) < 3) {
    part.field = FieldOf(text.substr(text.size() - letters));
    text.remove_suffix(letters);
    text = Stripped(text);
  }
  part.text = text;
  part.unit = !ReadQuantity(part.text, "");
  return part;
}

// Between numbers and their units: a cross, "by", or the signs of a list.
std::vector<Part> PartsOf(const std::string& written) {
  const std::string text = absl::StrReplaceAll(absl::AsciiStrToLower(written), {{"×", "|"},
                                                                                {"✕", "|"},
                                                                                {" by ", "|"},
                                                                                {"*", "|"},
                                                                                {"x", "|"},
                                                                                {", ", "|"},
                                                                                {";", "|"},
                                                                                {" / ", "|"},
                                                                                {"(", " "},
                                                                                {")", " "}});
  std::vector<Part> parts;
  for (const absl::string_view piece : absl::StrSplit(text, '|')) {
    parts.push_back(PartOf(std::string_view(piece.data(), piece.size())));
  }
  return parts;
}

std::vector<Part> PartsOf(const json& value) {
  std::vector<Part> parts;
  if (value.is_string() && value.get_ref<const std::string&>().size() <= kLongest) {
    return PartsOf(value.get_ref<const std::string&>());
  }
  if (!value.is_structured() || value.size() > kFields.size()) return parts;
  for (const auto& [key, member] : value.items()) {
    if (!member.is_number() && !member.is_string()) return {};
    Part part = PartOf(member.is_string() ? member.get<std::string>() : member.dump());
    if (value.is_object()) part.field = FieldOf(Bare(key));
    if (value.is_object() && part.field == 3) return {};
    parts.push_back(std::move(part));
  }
  return parts;
}

// The unit that the last part ends in goes to those before it; false when that leaves a doubt.
bool ShareUnit(std::string_view unit_of_key, std::vector<Part>& parts) {
  const auto with_unit = std::ranges::count_if(parts, &Part::unit);
  if (with_unit == static_cast<std::ptrdiff_t>(parts.size())) return true;
  if (with_unit == 0) {
    if (unit_of_key.empty()) return true;
    for (Part& part : parts) part.text += " " + std::string(unit_of_key);
    return true;
  }
  if (with_unit != 1 || !parts.back().unit) return false;
  const std::string& last = parts.back().text;
  size_t digits = 0;
  for (size_t i = 0; i < last.size(); ++i) {
    if (last[i] >= '0' && last[i] <= '9') digits = i + 1;
  }
  for (size_t i = 0; i + 1 < parts.size(); ++i) parts[i].text += last.substr(digits);
  return true;
}

// The parts as members; nothing when there are too few or many, or one is no length or named twice.
std::optional<json> MembersOf(std::vector<Part> parts, std::string_view unit) {
  if (parts.size() < 2 || parts.size() > kFields.size() || !ShareUnit(unit, parts)) return std::nullopt;
  const auto named = std::ranges::count_if(parts, [](const Part& part) { return part.field < 3; });
  if (named != 0 && named != static_cast<std::ptrdiff_t>(parts.size())) return std::nullopt;
  json members = json::object();
  for (size_t i = 0; i < parts.size(); ++i) {
    const std::string field(kFields[named == 0 ? i : parts[i].field]);
    if (!ReadQuantity(parts[i].text, "m") || members.contains(field)) return std::nullopt;
    members[field] = parts[i].text;
  }
  return members;
}

// What a name for sizes says of them.
struct SizeKey {
  std::string_view unit;  // "cm" of "dimensions_cm"
  // The order of the lengths, by kFields: "hwd" of "dimensions (HxWxD)". Empty when it says none.
  std::vector<size_t> order;
};

// "hxwxd", "hwd", "heightxwidth": each field once.
std::vector<size_t> OrderIn(std::string_view rest) {
  std::vector<size_t> order;
  while (!rest.empty()) {
    if (rest.front() == 'x') rest.remove_prefix(1);
    const SizeWord* longest = nullptr;
    for (const SizeWord& word : kSizeWords) {
      if (rest.starts_with(word.word) && (longest == nullptr || word.word.size() > longest->word.size()))
        longest = &word;
    }
    if (longest == nullptr || std::ranges::find(order, longest->field) != order.end()) return {};
    order.push_back(longest->field);
    rest.remove_prefix(longest->word.size());
  }
  return order;
}

// Nothing for other names.
std::optional<SizeKey> SizeKeyOf(const std::string& key) {
  const std::string name = Bare(key);
  for (const std::string_view stem :
       {"dimensions", "dimension", "dims", "dim", "size", "measurements", "footprint", "extent", "extents"}) {
    if (!name.starts_with(stem)) continue;
    std::string_view rest = std::string_view(name).substr(stem.size());
    if (rest.empty()) return SizeKey{};
    if (std::vector<size_t> order = OrderIn(rest); !order.empty()) return SizeKey{{}, std::move(order)};
    if (const std::string_view unit = UnitNamed(rest, "m"); !unit.empty()) return SizeKey{unit, {}};
    if (!rest.starts_with("in")) continue;
    if (const std::string_view unit = UnitNamed(rest.substr(2), "m"); !unit.empty()) return SizeKey{unit, {}};
  }
  return std::nullopt;
}

// Parts that nothing else names by an order; none when there are not as many.
std::vector<Part> InOrder(std::vector<Part> parts, const std::vector<size_t>& order) {
  const bool named = std::ranges::any_of(parts, [](const Part& part) { return part.field < 3; });
  if (order.empty() || named) return parts;
  if (parts.size() != order.size()) return {};
  for (size_t i = 0; i < parts.size(); ++i) parts[i].field = order[i];
  return parts;
}

// "w", "d" and "h" among other members.
json LettersOf(const json& object) {
  json letters = json::object();
  for (const auto& [key, member] : object.items()) {
    if (key.size() == 1 && FieldOf(absl::AsciiStrToLower(key)) < 3) letters[key] = member;
  }
  return letters;
}

}  // namespace

std::optional<json> WithWrittenSize(const json& object, const Descriptor& type) {
  if (!object.is_object()) return std::nullopt;
  Members written(object, type);
  for (const std::string_view name : {kFields[0], kFields[1]}) {
    const auto* const field = type.FindFieldByName(std::string(name));
    if (field == nullptr || written.Find(*field).value != nullptr) return std::nullopt;
  }
  std::optional<json> members = MembersOf(PartsOf(LettersOf(object)), "");
  for (const auto& [key, member] : object.items()) {
    const std::optional<SizeKey> size = members ? std::nullopt : SizeKeyOf(key);
    if (size) members = MembersOf(InOrder(PartsOf(member), size->order), size->unit);
  }
  if (!members) return std::nullopt;
  json sized = object;
  for (const auto& [key, member] : members->items()) {
    const auto* const field = type.FindFieldByName(key);
    if (field != nullptr && written.Find(*field).value == nullptr) sized[key] = member;
  }
  return sized;
}

}  // namespace flair::llm
