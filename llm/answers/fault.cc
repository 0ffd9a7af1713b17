// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/fault.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "llm/answers/utf8.h"

namespace flair::llm {
namespace {

using google::protobuf::FieldDescriptor;
using ProtoMessage = google::protobuf::Message;

// The list that a path leads into, as the messages and fields on the way, and the element's number.
struct ElementRef {
  std::string list;  // "zones[1].objects"
  int index = 0;
};

// Innermost element of the path; nothing when it goes through no list.
std::optional<ElementRef> InnermostElement(std::string_view path) {
  const size_t close = path.rfind(']');
  if (close == std::string_view::npos) return std::nullopt;
  const size_t open = path.rfind('[', close);
  if (open == std::string_view::npos) return std::nullopt;
  ElementRef element{std::string(path.substr(0, open)), 0};
  const char* const end = path.data() + close;
  const auto [stop, error] = std::from_chars(path.data() + open + 1, end, element.index);
  if (error != std::errc() || stop != end) return std::nullopt;
  return element;
}

// The next step of a path: "zones[1].objects" gives "zones", 1 and leaves "objects".
struct PathStep {
  std::string name;
  int index = -1;
};

PathStep TakeStep(std::string_view& path) {
  const size_t dot = path.find('.');
  std::string_view step = path.substr(0, dot);
  path = dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
  PathStep result;
  const size_t open = step.find('[');
  if (open != std::string_view::npos) {
    std::from_chars(step.data() + open + 1, step.data() + step.size(), result.index);
    step = step.substr(0, open);
  }
  result.name = std::string(step);
  return result;
}

void RemoveElements(std::string_view list_path, const std::set<int>& indices, ProtoMessage& root) {
  ProtoMessage* message = &root;
  while (true) {
    const PathStep step = TakeStep(list_path);
    const FieldDescriptor* field = message->GetDescriptor()->FindFieldByName(step.name);
    if (field == nullptr) return;
    const google::protobuf::Reflection& reflection = *message->GetReflection();
    if (list_path.empty()) {
      if (!field->is_repeated()) return;
      for (auto index = indices.rbegin(); index != indices.rend(); ++index) {
        int size = reflection.FieldSize(*message, field);
        if (*index < 0 || *index >= size) continue;
        for (int i = *index; i + 1 < size; ++i) reflection.SwapElements(message, field, i, i + 1);
        reflection.RemoveLast(message, field);
      }
      return;
    }
    if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) return;
    if (field->is_repeated()) {
      if (step.index < 0 || step.index >= reflection.FieldSize(*message, field)) return;
      message = reflection.MutableRepeatedMessage(message, field, step.index);
    } else {
      message = reflection.MutableMessage(message, field);
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
  std::map<std::string, std::set<int>> elements;
  for (const Fault& fault : faults) {
    if (fault.kind != FaultKind::kWrong) continue;
    if (const auto element = InnermostElement(fault.path)) {
      elements[element->list].insert(element->index);
    } else {
      in_none.push_back(fault);
    }
  }
  // Inner lists first: numbers of outer elements still count then. A longer path never holds a shorter one's list.
  std::vector<std::pair<std::string, std::set<int>>> order(elements.begin(), elements.end());
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first.size() > b.first.size(); });
  for (const auto& [list, indices] : order) RemoveElements(list, indices, message);
  return in_none;
}

}  // namespace flair::llm
