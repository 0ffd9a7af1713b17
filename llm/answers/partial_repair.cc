// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/partial_repair.h"

#include <fmt/format.h>
#include <google/protobuf/util/json_util.h>

#include <charconv>
#include <iterator>
#include <string_view>
#include <utility>

#include "llm/answers/choices.h"
#include "llm/answers/read_answer.h"

namespace flair::llm {
namespace {

using google::protobuf::FieldDescriptor;
using ProtoMessage = google::protobuf::Message;
using nlohmann::json;

// "objects[3].width_m": the element of the root's list, and what follows it.
struct RootElement {
  std::string list;
  int number = 0;
  std::string rest;
};

std::optional<RootElement> RootElementOf(const std::string& path) {
  const size_t open = path.find('[');
  if (open == std::string::npos || path.find('.') < open) return std::nullopt;
  RootElement element{path.substr(0, open), 0, {}};
  const char* const end = path.data() + path.size();
  const auto [stop, error] = std::from_chars(path.data() + open + 1, end, element.number);
  if (error != std::errc() || stop == end || *stop != ']') return std::nullopt;
  element.rest = std::string(stop + 1, end);
  return element;
}

const FieldDescriptor* ListOf(const ProtoMessage& message, const std::string& name) {
  const FieldDescriptor* field = message.GetDescriptor()->FindFieldByName(name);
  const bool list = field != nullptr && field->is_repeated() && field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
  return list ? field : nullptr;
}

// What names an element: the text that its type begins with. Null when it begins with something else.
const FieldDescriptor* KeyOf(const FieldDescriptor& list) {
  const FieldDescriptor* first = list.message_type()->field_count() > 0 ? list.message_type()->field(0) : nullptr;
  const bool text = first != nullptr && !first->is_repeated() && first->cpp_type() == FieldDescriptor::CPPTYPE_STRING;
  return text ? first : nullptr;
}

std::string KeyText(const ProtoMessage& message, const FieldDescriptor& list, int number, const FieldDescriptor& key) {
  const ProtoMessage& element = message.GetReflection()->GetRepeatedMessage(message, &list, number);
  return Bare(element.GetReflection()->GetString(element, &key));
}

// Which element of the first answer each one of the repair replaces; -1 for none.
std::vector<int> Place(const ProtoMessage& repair, const ProtoMessage& answer, const FieldDescriptor& list,
                       const std::set<int>& numbers) {
  const int count = repair.GetReflection()->FieldSize(repair, &list);
  const int whole = answer.GetReflection()->FieldSize(answer, &list);
  std::vector<int> places(static_cast<size_t>(count), -1);
  const FieldDescriptor* const key = KeyOf(list);
  if (key == nullptr) {
    const bool in_order = count == static_cast<int>(numbers.size());
    for (int i = 0; i < count && (in_order || count == whole); ++i) {
      if (in_order) places[static_cast<size_t>(i)] = *std::next(numbers.begin(), i);
      if (!in_order && numbers.contains(i)) places[static_cast<size_t>(i)] = i;
    }
    return places;
  }
  std::set<int> open = numbers;
  std::set<std::string> good;  // names of what was right already
  for (int i = 0; i < whole; ++i) {
    if (!numbers.contains(i)) good.insert(KeyText(answer, list, i, *key));
  }
  for (int i = 0; i < count; ++i) {
    const std::string name = KeyText(repair, list, i, *key);
    for (const int number : open) {
      if (name.empty() || KeyText(answer, list, number, *key) != name) continue;
      places[static_cast<size_t>(i)] = number;
      open.erase(number);
      break;
    }
  }
  // Those with a new name, in their order.
  for (int i = 0; i < count; ++i) {
    const std::string name = KeyText(repair, list, i, *key);
    if (places[static_cast<size_t>(i)] >= 0 || open.empty() || name.empty() || good.contains(name)) continue;
    places[static_cast<size_t>(i)] = *open.begin();
    open.erase(open.begin());
  }
  return places;
}

}  // namespace

std::optional<Elements> FaultyElements(std::span<const Fault> faults, const ProtoMessage& answer) {
  Elements elements;
  for (const Fault& fault : faults) {
    if (fault.kind == FaultKind::kMended) continue;
    const std::optional<RootElement> element = RootElementOf(fault.path);
    const FieldDescriptor* list = element ? ListOf(answer, element->list) : nullptr;
    if (list == nullptr || element->number < 0 || element->number >= answer.GetReflection()->FieldSize(answer, list)) {
      return std::nullopt;
    }
    elements[element->list].insert(element->number);
  }
  if (elements.empty()) return std::nullopt;
  return elements;
}

std::string PartOf(const json& written, const ProtoMessage& answer, const Elements& elements) {
  const json root = AnswerRoot(written, *answer.GetDescriptor());
  google::protobuf::util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  json part;
  for (const auto& [name, numbers] : elements) {
    const FieldDescriptor& list = *ListOf(answer, name);
    const bool as_written = root.is_object() && root.contains(name) && root[name].is_array();
    for (const int number : numbers) {
      const auto at = static_cast<size_t>(number);
      if (as_written && at < root[name].size()) {
        part[name].push_back(root[name][at]);
        continue;
      }
      std::string text;
      const ProtoMessage& element = answer.GetReflection()->GetRepeatedMessage(answer, &list, number);
      const bool printed = google::protobuf::util::MessageToJsonString(element, &text, options).ok();
      part[name].push_back(printed ? json::parse(text, nullptr, /*allow_exceptions=*/false) : json());
    }
  }
  return part.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::vector<Fault> NumberedInPart(std::span<const Fault> faults, const Elements& elements) {
  std::vector<Fault> numbered;
  for (const Fault& fault : faults) {
    const std::optional<RootElement> element = RootElementOf(fault.path);
    const auto list = element ? elements.find(element->list) : elements.end();
    if (list == elements.end()) continue;
    const auto found = list->second.find(element->number);
    if (found == list->second.end()) continue;
    const auto number = std::distance(list->second.begin(), found);
    numbered.push_back({fmt::format("{}[{}]{}", element->list, number, element->rest), fault.text, fault.kind});
  }
  return numbered;
}

Merged MergeElements(const ProtoMessage& repair, std::span<const Fault> faults, const Elements& elements,
                     ProtoMessage& answer) {
  Merged merged;
  for (const auto& [name, numbers] : elements) {
    const FieldDescriptor& list = *ListOf(answer, name);
    const std::vector<int> places = Place(repair, answer, list, numbers);
    for (size_t i = 0; i < places.size(); ++i) {
      if (places[i] < 0) continue;
      answer.GetReflection()
          ->MutableRepeatedMessage(&answer, &list, places[i])
          ->CopyFrom(repair.GetReflection()->GetRepeatedMessage(repair, &list, static_cast<int>(i)));
      merged.replaced[name].insert(places[i]);
    }
    for (const Fault& fault : faults) {
      const std::optional<RootElement> element = RootElementOf(fault.path);
      if (!element || element->list != name || element->number >= static_cast<int>(places.size())) continue;
      const int place = places[static_cast<size_t>(element->number)];
      if (place < 0) continue;
      merged.faults.push_back({fmt::format("{}[{}]{}", name, place, element->rest), fault.text, fault.kind});
    }
  }
  return merged;
}

}  // namespace flair::llm
