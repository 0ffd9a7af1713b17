// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <set>

#include "llm/answers/read_answer.h"
#include "llm/answers/utf8.h"

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

}  // namespace flair::llm
