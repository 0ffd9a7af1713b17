// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/extract_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "llm/answers/choices.h"
#include "llm/answers/json_scan.h"
#include "llm/answers/json_words.h"
#include "llm/answers/utf8.h"

namespace flair::llm {
namespace {

using nlohmann::json;

constexpr size_t kMostBytes = 1'000'000;
constexpr int kMostCandidates = 50;

std::string_view Trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n\v\f";
  const size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

// What follows a model's thinking aloud.
std::string_view WithoutThoughts(std::string_view text) {
  constexpr std::string_view kEnd = "</think>";
  const size_t end = text.rfind(kEnd);
  return end == std::string_view::npos ? text : text.substr(end + kEnd.size());
}

bool IsHtml(std::string_view text) {
  const std::string start = Bare(text.substr(0, 60));
  return text.starts_with('<') && (start.starts_with("doctypehtml") || start.starts_with("html"));
}

// Whether a text begins with a key without quotes: "name:".
bool BeginsWithKey(std::string_view text) {
  size_t end = 0;
  while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '_')) ++end;
  const size_t next = text.find_first_not_of(" \t", end);
  return end > 0 && next != std::string_view::npos && text[next] == ':';
}

// Whether the text behind a bracket is how JSON goes on, rather than prose in brackets.
bool LooksLikeJson(std::string_view text, size_t start) {
  const size_t next = text.find_first_not_of(" \t\r\n", start + 1);
  if (next == std::string_view::npos || QuoteLength(text.substr(next)) > 0) return true;
  if (text.substr(next).starts_with("# ")) return true;
  if (text[start] == '{') return text[next] == '}' || text[next] == '/' || BeginsWithKey(text.substr(next));
  return std::string_view("{[-0123456789tfn]/").find(text[next]) != std::string_view::npos;
}

// Parses text whose brackets match; on failure `fault` says where and what.
json Parse(const std::string& text, Fault& fault) {
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    const size_t byte = std::min(error.byte, text.size());
    const std::string place = ScanJson(CutCharacters(text, byte), 0).path;
    const size_t from = byte > 20 ? byte - 20 : 0;
    fault.text = fmt::format("is no valid JSON{}{}, near {}; plain JSON with double quotes would be right",
                             place.empty() ? "" : " at ", place, Quoted(std::string_view(text).substr(from, 40)));
  } catch (const json::exception&) {
    fault.text = "is no valid JSON: a number is too large; plain JSON would be right";
  }
  return json(json::value_t::discarded);
}

// The text within a JSON string that is all of a text: some gateways quote the whole answer. Else the text.
std::string WithoutQuotation(std::string_view text) {
  if (!text.starts_with('"')) return std::string(text);
  const json value = json::parse(text, nullptr, /*allow_exceptions=*/false);
  const bool holds_json = value.is_string() && value.get_ref<const std::string&>().find('{') != std::string::npos;
  return holds_json ? value.get<std::string>() : std::string(text);
}

// What the search for the value has found so far.
class Search {
 public:
  explicit Search(std::span<const std::string> keys) {
    for (const std::string& key : keys) keys_.push_back(Bare(key));
  }

  void Run(std::string_view text) {
    int tried = 0;
    for (size_t at = text.find_first_of("{["); at != std::string_view::npos && tried < kMostCandidates;
         at = text.find_first_of("{[", at)) {
      if (!LooksLikeJson(text, at)) {
        ++at;
        continue;
      }
      ++tried;
      at = std::max(at + 1, Try(text, at));
    }
  }

  ExtractedJson Take(std::string_view text) {
    if (best_known_ <= 1 && !salvaged_ && elements_.size() > 1) return {std::move(elements_), {}};
    // A value without any of the keys is an example or an aside when another one was cut off.
    if (best_ && (best_known_ > 1 || !salvaged_)) return {std::move(*best_), {}};
    if (salvaged_ && fault_) return {std::move(*salvaged_), {*fault_}};
    if (fault_) return {json(json::value_t::discarded), {*fault_}};
    return {json(json::value_t::discarded),
            {{"", fmt::format("has no JSON; it says {}; one JSON object and nothing else would be right",
                              Quoted(Trimmed(text)))}}};
  }

 private:
  // Tries the value that starts at `at` and returns where to look on.
  size_t Try(std::string_view text, size_t at) {
    const JsonScan scan = ScanJson(text, at);
    Fault fault;
    if (scan.end == JsonScan::End::kComplete) {
      // What is wrong is told of the first alone.
      json value = fault_ ? json::parse(scan.json, nullptr, /*allow_exceptions=*/false) : Parse(scan.json, fault);
      if (value.is_discarded()) {
        if (!fault_) fault_ = fault;
      } else {
        // An empty list among other things is a part of something that is no JSON.
        const bool alone = text.find_first_of("{[") == at && text.find_first_of("{[", scan.stop) == text.npos;
        if (!value.is_array() || !value.empty() || alone) Offer(std::move(value));
      }
      return scan.stop;
    }
    const std::string place = scan.path.empty() ? "" : " inside " + scan.path;
    if (scan.end == JsonScan::End::kTooDeep) {
      if (!fault_) fault_ = Fault{"", "is nested deeper than any answer; plain JSON would be right"};
      return scan.stop;
    }
    if (scan.end == JsonScan::End::kBroken) {
      fault.text = fmt::format("is no valid JSON: a bracket that does not match{}, near {}", place,
                               Quoted(text.substr(scan.stop > 20 ? scan.stop - 20 : 0, 40)));
      if (!fault_) fault_ = fault;
      return scan.stop;
    }
    fault.text = fmt::format("ended{}, after {}; the whole JSON would be right, shorter if need be", place,
                             Quoted(text.substr(text.size() > 30 ? text.size() - 30 : 0)));
    json value = scan.salvaged.empty() ? json(json::value_t::discarded) : Parse(scan.salvaged, fault);
    if (!value.is_discarded()) {
      fault.kind = scan.only_unclosed ? FaultKind::kMended : FaultKind::kDoubtful;
      salvaged_ = std::move(value);
      fault_ = fault;
    } else if (!fault_) {
      fault_ = fault;
    }
    // Whatever values follow are parts of this one.
    return text.size();
  }

  void Offer(json value) {
    int known = 0;
    if (value.is_object()) {
      for (const auto& [key, member] : value.items()) {
        known += std::find(keys_.begin(), keys_.end(), Bare(key)) != keys_.end() ? 2 : 0;
      }
      ++known;  // an object before a list
      if (known == 1 && !value.empty()) elements_.push_back(value);
    }
    if (best_ && known < best_known_) return;
    best_ = std::move(value);
    best_known_ = known;
  }

  std::vector<std::string> keys_;
  // The objects without any of the keys: a list's elements, when there is nothing else.
  json elements_ = json::array();
  std::optional<json> best_;
  int best_known_ = 0;
  std::optional<json> salvaged_;
  std::optional<Fault> fault_;  // of the first value that is none
};

}  // namespace

ExtractedJson ExtractJson(std::string_view answer, std::span<const std::string> keys) {
  const auto no_value = [](std::string text) {
    return ExtractedJson{json(json::value_t::discarded), {{"", std::move(text)}}};
  };
  if (answer.size() > kMostBytes) {
    return no_value(fmt::format("has {} bytes; at most {}", answer.size(), kMostBytes));
  }
  const std::string good = PlainSpaces(ToUtf8(answer));
  const std::string_view text = Trimmed(WithoutThoughts(good));
  if (text.empty()) return no_value("is empty; one JSON object would be right");
  if (IsHtml(text)) return no_value(fmt::format("is an HTML page, {}; one JSON object would be right", Quoted(text)));
  Search search(keys);
  const std::string unquoted = WithoutQuotation(text);
  search.Run(unquoted);
  return search.Take(unquoted);
}

}  // namespace flair::llm
