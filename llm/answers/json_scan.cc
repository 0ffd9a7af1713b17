// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/json_scan.h"

#include <fmt/format.h>

#include <vector>

#include "llm/answers/utf8.h"

namespace flair::llm {
namespace {

constexpr size_t kMostNesting = 64;

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool IsSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

class Scanner {
 public:
  Scanner(std::string_view text, size_t start) : text_(text), at_(start) {}

  JsonScan Scan() {
    JsonScan scan;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (IsSpace(c) || (c == '/' && SkipComment())) {
        scan.json += ' ';
      } else if (c == '"') {
        EmitComma(scan.json);
        ReadString(scan.json);
      } else if (c == ',') {
        comma_ = true;
        if (!frames_.empty() && frames_.back().bracket == '[') ++frames_.back().index;
        if (!frames_.empty()) frames_.back().key.clear();
      } else if (c == '{' || c == '[') {
        if (frames_.size() == kMostNesting) {
          // Nothing inside it is worth a look.
          scan.end = JsonScan::End::kTooDeep;
          scan.stop = text_.size();
          return scan;
        }
        EmitComma(scan.json);
        scan.json += c;
        frames_.push_back({c});
      } else if (c == '}' || c == ']') {
        if (frames_.empty() || (c == '}') != (frames_.back().bracket == '{')) break;
        Close(c, scan);
        if (frames_.empty()) {
          scan.end = JsonScan::End::kComplete;
          scan.stop = at_ + 1;
          return scan;
        }
      } else if (IsLetter(c)) {
        EmitComma(scan.json);
        ReadWord(scan.json);
      } else {
        if (c != ':') EmitComma(scan.json);
        scan.json += c;
      }
    }
    scan.end = at_ < text_.size() ? JsonScan::End::kBroken : JsonScan::End::kTruncated;
    scan.stop = at_ < text_.size() ? at_ + 1 : at_;
    scan.path = Path();
    if (scan.end == JsonScan::End::kTruncated && whole_ > 0) scan.salvaged = scan.json.substr(0, whole_) + closers_;
    return scan;
  }

 private:
  struct Frame {
    char bracket;
    int index = 0;      // of a list
    std::string key{};  // of an object
  };

  // A comma is written when something follows it.
  void EmitComma(std::string& json) {
    if (comma_) json += ',';
    comma_ = false;
  }

  void Close(char c, JsonScan& scan) {
    comma_ = false;
    scan.json += c;
    frames_.pop_back();
    if (frames_.empty() || frames_.back().bracket != '[') return;
    whole_ = scan.json.size();
    closers_.clear();
    for (auto frame = frames_.rbegin(); frame != frames_.rend(); ++frame) closers_ += frame->bracket == '{' ? '}' : ']';
  }

  // Copies the string that begins here; at_ ends on its closing quote, or behind the text.
  void ReadString(std::string& json) {
    const bool is_key = !frames_.empty() && frames_.back().bracket == '{' && frames_.back().key.empty();
    std::string content;
    json += '"';
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      const char c = text_[at_];
      if (static_cast<unsigned char>(c) < 0x20) {
        json += fmt::format("\\u{:04x}", static_cast<int>(c));
        continue;
      }
      json += c;
      content += c;
      if (c == '\\' && at_ + 1 < text_.size()) json += text_[++at_];
    }
    if (at_ < text_.size()) json += '"';
    constexpr size_t kMostKey = 40;
    if (is_key) frames_.back().key = content.empty() ? "?" : CutCharacters(content, kMostKey);
  }

  // Copies the word that begins here, Python's as JSON's; at_ ends on its last letter.
  void ReadWord(std::string& json) {
    const size_t start = at_;
    while (at_ + 1 < text_.size() && IsLetter(text_[at_ + 1])) ++at_;
    const std::string_view word = text_.substr(start, at_ + 1 - start);
    if (word == "True") {
      json += "true";
    } else if (word == "False") {
      json += "false";
    } else if (word == "None" || word == "undefined" || word == "NaN") {
      json += "null";
    } else {
      json += word;
    }
  }

  // "// ..." to the end of the line and "/* ... */"; at_ ends on its last byte.
  bool SkipComment() {
    if (at_ + 1 >= text_.size()) return false;
    if (text_[at_ + 1] == '/') {
      while (at_ + 1 < text_.size() && text_[at_ + 1] != '\n') ++at_;
      return true;
    }
    if (text_[at_ + 1] != '*') return false;
    const size_t end = text_.find("*/", at_ + 2);
    at_ = end == std::string_view::npos ? text_.size() - 1 : end + 1;
    return true;
  }

  std::string Path() const {
    std::string path;
    for (const Frame& frame : frames_) {
      if (frame.bracket == '[') {
        path += fmt::format("[{}]", frame.index);
      } else if (!frame.key.empty()) {
        path += (path.empty() ? "" : ".") + frame.key;
      }
    }
    return path;
  }

  const std::string_view text_;
  size_t at_;
  std::vector<Frame> frames_;
  bool comma_ = false;
  size_t whole_ = 0;     // length of the JSON up to the last whole list element; 0 for none
  std::string closers_;  // what closes it there
};

}  // namespace

JsonScan ScanJson(std::string_view text, size_t start) { return Scanner(text, start).Scan(); }

}  // namespace flair::llm
