// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <span>

#include "llm/answers/read_answer.h"

namespace flair::llm {
namespace {

using google::protobuf::FieldDescriptor;
using ProtoMessage = google::protobuf::Message;

// The path of the innermost list element of a path; empty when it goes through no list.
std::string ElementOf(const std::string& path) {
  const size_t close = path.rfind(']');
  return close == std::string::npos ? "" : path.substr(0, close + 1);
}

// Removes the list elements with these paths from a message that is itself at `path`.
void RemoveElements(const std::set<std::string>& elements, const std::string& path, ProtoMessage& message) {
  const google::protobuf::Reflection& reflection = *message.GetReflection();
  std::vector<const FieldDescriptor*> fields;
  reflection.ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    const bool of_messages = field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
    const std::string at = path + field->name();
    if (!field->is_repeated()) {
      if (of_messages) RemoveElements(elements, at + ".", *reflection.MutableMessage(&message, field));
      continue;
    }
    // From the last, whose numbers the others do not change.
    for (int i = reflection.FieldSize(message, field) - 1; i >= 0; --i) {
      const std::string element = fmt::format("{}[{}]", at, i);
      if (of_messages) RemoveElements(elements, element + ".", *reflection.MutableRepeatedMessage(&message, field, i));
      if (!elements.contains(element)) continue;
      for (int k = i; k + 1 < reflection.FieldSize(message, field); ++k) {
        reflection.SwapElements(&message, field, k, k + 1);
      }
      reflection.RemoveLast(&message, field);
    }
  }
}

// Bytes of the UTF-8 character that starts at `at`; 0 when none does.
size_t CharacterAt(std::string_view text, size_t at) {
  const auto byte = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0; };
  const auto follows = [&](size_t i) { return (byte(i) & 0xC0) == 0x80; };
  const unsigned char lead = byte(at);
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead < 0xE0) return follows(at + 1) ? 2 : 0;
  if (lead >= 0xE0 && lead < 0xF0) {
    // Overlong forms and surrogates are none.
    if ((lead == 0xE0 && byte(at + 1) < 0xA0) || (lead == 0xED && byte(at + 1) > 0x9F)) return 0;
    return follows(at + 1) && follows(at + 2) ? 3 : 0;
  }
  if (lead < 0xF0 || lead > 0xF4) return 0;
  if ((lead == 0xF0 && byte(at + 1) < 0x90) || (lead == 0xF4 && byte(at + 1) > 0x8F)) return 0;
  return follows(at + 1) && follows(at + 2) && follows(at + 3) ? 4 : 0;
}

// A stretch of characters with the same first two bytes, by the third.
struct Stretch {
  std::string_view start;
  unsigned char least, most;
  std::string_view plain;
};

constexpr Stretch kSpaces[] = {
    {"\xC2", 0xA0, 0xA0, " "},    {"\xC2", 0xAD, 0xAD, ""},      {"\xE2\x80", 0x80, 0x8A, " "},
    {"\xE2\x80", 0x8B, 0x8B, ""}, {"\xE2\x80", 0x8E, 0x8F, ""},  {"\xE2\x80", 0xA8, 0xA9, "\n"},
    {"\xE2\x80", 0xAA, 0xAE, ""}, {"\xE2\x80", 0xAF, 0xAF, " "}, {"\xE2\x81", 0x9F, 0x9F, " "},
    {"\xE2\x81", 0xA0, 0xA0, ""}, {"\xE2\x81", 0xA6, 0xA9, ""},  {"\xE3\x80", 0x80, 0x80, " "},
    {"\xEF\xBB", 0xBF, 0xBF, ""}};

std::string Replaced(std::string_view text, std::span<const Stretch> stretches) {
  std::string plain;
  plain.reserve(text.size());
  for (size_t i = 0; i < text.size();) {
    const size_t length = CharacterAt(text, i);
    const std::string_view character = text.substr(i, length == 0 ? 1 : length);
    const auto found = std::ranges::find_if(stretches, [&](const Stretch& stretch) {
      const auto last = static_cast<unsigned char>(character.back());
      return character.size() == stretch.start.size() + 1 && character.starts_with(stretch.start) &&
             last >= stretch.least && last <= stretch.most;
    });
    plain += found == stretches.end() ? character : found->plain;
    i += character.size();
  }
  return plain;
}

bool IsAscii(std::string_view text) {
  return std::ranges::none_of(text, [](char c) { return (static_cast<unsigned char>(c) & 0x80) != 0; });
}

}  // namespace

std::string Fault::Sentence() const { return path.empty() ? text : fmt::format("{}: {}", path, text); }

std::string Quoted(std::string_view value) {
  constexpr size_t kMostBytes = 60;
  // A part of a text may begin or end within a character.
  std::string text = ToUtf8(value.substr(0, kMostBytes + 4));
  const bool cut = value.size() > kMostBytes + 4 || text.size() > kMostBytes;
  if (text.size() > kMostBytes) text = CutCharacters(text, kMostBytes);
  return fmt::format("\"{}{}\"", WithoutControls(std::move(text)), cut ? "…" : "");
}

std::string WithoutQuotations(std::string_view text) {
  std::string kept;
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') {
      quoted = !quoted;
      if (quoted) kept += "\"…\"";
    } else if (!quoted) {
      kept += c;
    }
  }
  return kept;
}

std::vector<Fault> DropFaulty(std::span<const Fault> faults, ProtoMessage& message) {
  std::vector<Fault> in_none;
  std::set<std::string> elements;
  for (const Fault& fault : faults) {
    if (fault.kind != FaultKind::kWrong) continue;
    const std::string element = ElementOf(fault.path);
    if (element.empty()) in_none.push_back(fault);
    if (!element.empty()) elements.insert(element);
  }
  if (!elements.empty()) RemoveElements(elements, "", message);
  return in_none;
}

std::string PlainSpaces(std::string text) { return IsAscii(text) ? text : Replaced(text, kSpaces); }

std::string ToUtf8(std::string_view text) {
  std::string good;
  good.reserve(text.size());
  size_t copied = 0;
  for (size_t i = 0; i < text.size();) {
    if (static_cast<unsigned char>(text[i]) < 0x80) {
      ++i;
    } else if (const size_t length = CharacterAt(text, i); length > 0) {
      i += length;
    } else {
      good.append(text, copied, i - copied) += "\xEF\xBF\xBD";
      copied = ++i;
    }
  }
  return good.append(text, copied);
}

std::string CutCharacters(std::string_view text, size_t most) {
  if (text.size() <= most) return std::string(text);
  size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return std::string(text.substr(0, end));
}

std::string CutBytes(const std::string& text, size_t most) {
  return text.size() <= most ? text : CutCharacters(text, most) + " …";
}

std::string WithoutControls(std::string text, std::string_view kept) {
  for (char& c : text) {
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    if (control && kept.find(c) == std::string_view::npos) c = ' ';
  }
  return text;
}

}  // namespace flair::llm
