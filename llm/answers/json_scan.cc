// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/json_scan.h"

#include <fmt/format.h>

#include <vector>

#include "llm/answers/json_words.h"
#include "llm/answers/utf8.h"

namespace flair::llm {
namespace {

constexpr size_t kMostNesting = 64;

// Control characters too: they mean nothing between values.
bool IsSpace(char c) { return static_cast<unsigned char>(c) <= ' '; }

class Scanner {
 public:
  Scanner(std::string_view text, size_t start) : text_(text), at_(start) {}

  JsonScan Scan() {
    JsonScan scan;
    for (; at_ < text_.size(); ++at_) {
      const char full_width = FullWidthMark(text_.substr(at_));
      if (full_width != 0) at_ += 2;
      const char c = full_width != 0 ? full_width : text_[at_];
      if (IsSpace(c) || ((c == '/' || c == '#') && SkipComment())) {
        scan.json += ' ';
      } else if (c == ',') {
        comma_ = true;
        closed_last_ = false;
        if (!frames_.empty()) EndElement(frames_.back());
      } else if (c == ':') {
        scan.json += c;
      } else if (c == '{' || c == '[') {
        if (frames_.size() == kMostNesting) {
          // Nothing inside it is worth a look.
          scan.end = JsonScan::End::kTooDeep;
          scan.stop = text_.size();
          return scan;
        }
        BeginValue(scan.json);
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
      } else {
        ReadText(scan.json);
      }
    }
    scan.end = at_ < text_.size() ? JsonScan::End::kBroken : JsonScan::End::kTruncated;
    scan.stop = at_ < text_.size() ? at_ + 1 : at_;
    scan.path = Path();
    if (scan.end != JsonScan::End::kTruncated) return scan;
    scan.only_unclosed = frames_.size() == 1 && frames_.front().bracket == '{' && closed_last_;
    if (scan.only_unclosed) {
      scan.salvaged = scan.json + '}';
    } else if (whole_ > 0) {
      scan.salvaged = scan.json.substr(0, whole_) + closers_;
    }
    return scan;
  }

 private:
  struct Frame {
    char bracket;
    int index = 0;       // of a list
    std::string key{};   // of an object
    bool ended = false;  // the element has its value
  };

  static void EndElement(Frame& frame) {
    if (frame.bracket == '[') ++frame.index;
    frame.key.clear();
    frame.ended = false;
  }

  // A comma is written when something follows it, or where one is missing.
  void BeginValue(std::string& json) {
    if (!frames_.empty() && frames_.back().ended) {
      EndElement(frames_.back());
      comma_ = true;
    }
    if (comma_) json += ',';
    comma_ = false;
  }

  // Of a string, number or word that was read.
  void EndValue(std::string_view content) {
    if (frames_.empty()) return;
    Frame& frame = frames_.back();
    if (frame.bracket == '{' && frame.key.empty()) {
      constexpr size_t kMostKey = 40;
      frame.key = content.empty() ? "?" : WithoutControls(CutCharacters(content, kMostKey));
    } else {
      frame.ended = true;
    }
  }

  void Close(char c, JsonScan& scan) {
    comma_ = false;
    closed_last_ = true;
    scan.json += c;
    frames_.pop_back();
    if (frames_.empty()) return;
    frames_.back().ended = true;
    if (frames_.back().bracket != '[') return;
    whole_ = scan.json.size();
    closers_.clear();
    for (auto frame = frames_.rbegin(); frame != frames_.rend(); ++frame) closers_ += frame->bracket == '{' ? '}' : ']';
  }

  // Copies the string, number or word that begins here; at_ ends on its last byte.
  void ReadText(std::string& json) {
    closed_last_ = false;
    BeginValue(json);
    const std::string_view rest = text_.substr(at_);
    // In a list alone a word is rather prose: "[as asked]".
    const bool within_object = !frames_.empty() && frames_.front().bracket == '{';
    const JsonWord word = QuoteLength(rest) > 0 ? ReadQuoted(rest, json) : ReadBare(rest, within_object, json);
    EndValue(word.content);
    at_ += word.length - 1;
  }

  // "// ..." and "# ..." to the end of the line and "/* ... */"; at_ ends on its last byte.
  bool SkipComment() {
    if (at_ + 1 >= text_.size()) return false;
    // "#7A8B6F" is a value.
    const bool hash = text_[at_] == '#';
    if (hash && !IsSpace(text_[at_ + 1])) return false;
    if (hash || text_[at_ + 1] == '/') {
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
  bool closed_last_ = false;  // the last of it, but for space, was a closing bracket
  size_t whole_ = 0;          // length of the JSON up to the last whole list element; 0 for none
  std::string closers_;       // what closes it there
};

}  // namespace

JsonScan ScanJson(std::string_view text, size_t start) { return Scanner(text, start).Scan(); }

}  // namespace flair::llm
