// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "llm/answers/read_answer.h"

namespace flair::llm {
namespace {

using nlohmann::json;

constexpr size_t kMostBytes = 1'000'000;
constexpr int kMostCandidates = 50;
constexpr size_t kMostNesting = 64;

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

// Whether the text behind a bracket is how JSON goes on, rather than prose in brackets.
bool LooksLikeJson(std::string_view text, size_t start) {
  const size_t next = text.find_first_not_of(" \t\r\n", start + 1);
  if (next == std::string_view::npos) return true;
  return std::string_view(text[start] == '{' ? "\"}/" : "\"{[]-0123456789tfn/").find(text[next]) !=
         std::string_view::npos;
}

// A stretch of text that may be one JSON value, found by its brackets.
struct JsonScan {
  // How it ended: with its own closing bracket, with the text, with a bracket that closes another kind, or too deep.
  enum class End { kComplete, kTruncated, kBroken, kTooDeep };
  End end = End::kBroken;
  // Behind its last byte.
  size_t stop = 0;
  // The value without comments and trailing commas, control characters in texts escaped.
  std::string json;
  // When truncated: the value up to the last list element that is whole, closed; empty when there is none.
  std::string salvaged;
};

// Scans the bracket at a place of a text to its end. Linear in the text.
class Scanner {
 public:
  Scanner(std::string_view text, size_t start) : text_(text), at_(start) {}

  JsonScan Scan() {
    scan_.end = JsonScan::End::kTruncated;
    while (at_ < text_.size() && scan_.end == JsonScan::End::kTruncated) {
      const char c = text_[at_];
      if (c == '"') {
        CopyString();
      } else if (c == '/' && SkipComment()) {
        continue;
      } else if (c == '{' || c == '[') {
        Open(c);
      } else if (c == '}' || c == ']') {
        Close(c);
      } else {
        scan_.json += c;
      }
      ++at_;
    }
    scan_.stop = std::min(at_, text_.size());
    if (scan_.end == JsonScan::End::kTruncated && whole_ > 0) scan_.salvaged = scan_.json.substr(0, whole_) + closers_;
    return std::move(scan_);
  }

 private:
  // at_ ends on its last byte.
  void CopyString() {
    scan_.json += '"';
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      const char c = text_[at_];
      if (static_cast<unsigned char>(c) < 0x20) {
        scan_.json += fmt::format("\\u{:04x}", static_cast<int>(c));
        continue;
      }
      scan_.json += c;
      if (c == '\\' && at_ + 1 < text_.size()) scan_.json += text_[++at_];
    }
    scan_.json += '"';
  }

  // "// ..." to the end of the line and "/* ... */"; at_ ends behind it.
  bool SkipComment() {
    const bool line = text_.substr(at_).starts_with("//");
    if (!line && !text_.substr(at_).starts_with("/*")) return false;
    const size_t end = text_.find(line ? "\n" : "*/", at_ + 2);
    at_ = end == std::string_view::npos ? text_.size() : end + (line ? 1 : 2);
    return true;
  }

  void Open(char bracket) {
    if (open_.size() == kMostNesting) {
      scan_.end = JsonScan::End::kTooDeep;
      at_ = text_.size();
      return;
    }
    scan_.json += bracket;
    open_ += bracket;
  }

  void Close(char bracket) {
    if (open_.empty() || (bracket == '}') != (open_.back() == '{')) {
      scan_.end = JsonScan::End::kBroken;
      return;
    }
    // A comma before it is one too many.
    const size_t last = scan_.json.find_last_not_of(" \t\r\n");
    if (scan_.json[last] == ',') scan_.json.resize(last);
    scan_.json += bracket;
    open_.pop_back();
    if (open_.empty()) scan_.end = JsonScan::End::kComplete;
    if (open_.empty() || open_.back() != '[') return;
    whole_ = scan_.json.size();
    closers_.clear();
    for (auto open = open_.rbegin(); open != open_.rend(); ++open) closers_ += *open == '{' ? '}' : ']';
  }

  const std::string_view text_;
  size_t at_;
  JsonScan scan_;
  std::string open_;     // brackets that are open
  size_t whole_ = 0;     // length of the JSON up to the last whole list element; 0 for none
  std::string closers_;  // what closes it there
};

json Parsed(const std::string& text) { return json::parse(text, nullptr, /*allow_exceptions=*/false); }

// Where text whose brackets match is no JSON.
std::string NoJsonText(const std::string& text) {
  try {
    const json unused = json::parse(text);
  } catch (const json::parse_error& error) {
    const size_t byte = std::min(error.byte, text.size());
    return fmt::format("is no valid JSON near {}; plain JSON with double quotes would be right",
                       Quoted(std::string_view(text).substr(byte > 20 ? byte - 20 : 0, 40)));
  } catch (const json::exception&) {
    // Below.
  }
  return "is no valid JSON: a number is too large; plain JSON would be right";
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
    const JsonScan scan = Scanner(text, at).Scan();
    const std::string_view end = text.substr(0, scan.stop);
    const std::string near = Quoted(end.substr(end.size() > 30 ? end.size() - 30 : 0));
    if (scan.end == JsonScan::End::kComplete) {
      json value = Parsed(scan.json);
      if (value.is_discarded()) {
        Blame(NoJsonText(scan.json));
      } else if (!value.is_array() || !value.empty() || IsAlone(text, at, scan.stop)) {
        Offer(std::move(value));
      }
    } else if (scan.end == JsonScan::End::kTooDeep) {
      Blame("is nested deeper than any answer; plain JSON would be right");
    } else if (scan.end == JsonScan::End::kBroken) {
      Blame(fmt::format("is no valid JSON: a bracket that does not match near {}", near));
    } else {
      json value = scan.salvaged.empty() ? json(json::value_t::discarded) : Parsed(scan.salvaged);
      const std::string ended = fmt::format("ended after {}; the whole JSON would be right, shorter if need be", near);
      if (!value.is_discarded()) {
        salvaged_ = std::move(value);
        fault_ = Fault{"", ended, FaultKind::kDoubtful};
      } else {
        Blame(ended);
      }
    }
    return scan.stop;
  }

  // An empty list among other things is a part of something that is no JSON.
  static bool IsAlone(std::string_view text, size_t start, size_t stop) {
    return text.find_first_of("{[") == start && text.find_first_of("{[", stop) == std::string_view::npos;
  }

  // What is wrong is told of the first alone.
  void Blame(std::string text) {
    if (!fault_) fault_ = Fault{"", std::move(text)};
  }

  void Offer(json value) {
    int known = value.is_object() ? 1 : 0;  // an object before a list
    if (value.is_object()) {
      for (const auto& [key, member] : value.items())
        known += std::ranges::find(keys_, Bare(key)) != keys_.end() ? 2 : 0;
    }
    if (best_ && known < best_known_) return;
    best_ = std::move(value);
    best_known_ = known;
  }

  std::vector<std::string> keys_;
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
  if (answer.size() > kMostBytes) return no_value(fmt::format("has {} bytes; at most {}", answer.size(), kMostBytes));
  const std::string good = PlainSpaces(ToUtf8(answer));
  const std::string_view text = Trimmed(WithoutThoughts(good));
  if (text.empty()) return no_value("is empty; one JSON object would be right");
  if (IsHtml(text)) return no_value(fmt::format("is an HTML page, {}; one JSON object would be right", Quoted(text)));
  Search search(keys);
  search.Run(text);
  return search.Take(text);
}

}  // namespace flair::llm
