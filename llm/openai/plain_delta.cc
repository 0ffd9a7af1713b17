// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/openai/plain_delta.h"

#include <algorithm>
#include <cctype>

namespace flair::llm {
namespace {

// Walks over JSON text. Every step is false when the text does not go on so.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : rest_(text) {}

  bool Take(char c) {
    SkipSpace();
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }

  bool TakeWord(std::string_view word) {
    SkipSpace();
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }

  // A string with its quotation marks.
  bool TakeString(std::string_view& string) {
    SkipSpace();
    if (!rest_.starts_with('"')) return false;
    for (size_t i = 1; i < rest_.size(); ++i) {
      if (rest_[i] == '\\') {
        ++i;
      } else if (rest_[i] == '"') {
        string = rest_.substr(0, i + 1);
        rest_.remove_prefix(i + 1);
        return true;
      }
    }
    return false;
  }

  // Any value.
  bool Skip() {
    int depth = 0;
    do {
      SkipSpace();
      if (rest_.empty()) return false;
      const char c = rest_.front();
      std::string_view string;
      if (c == '"') {
        if (!TakeString(string)) return false;
      } else if (c == '{' || c == '[') {
        ++depth;
        rest_.remove_prefix(1);
      } else if (c == '}' || c == ']') {
        --depth;
        rest_.remove_prefix(1);
      } else if (depth > 0 && (c == ',' || c == ':')) {
        rest_.remove_prefix(1);
      } else if (!SkipWord()) {
        return false;
      }
    } while (depth > 0);
    return depth == 0;
  }

  // An object; `on_member` takes the key, with its quotation marks, and walks over the value.
  template <typename OnMember>
  bool TakeObject(const OnMember& on_member) {
    if (!Take('{')) return false;
    if (Take('}')) return true;
    do {
      std::string_view key;
      if (!TakeString(key) || !Take(':') || !on_member(key)) return false;
    } while (Take(','));
    return Take('}');
  }

  bool AtEnd() {
    SkipSpace();
    return rest_.empty();
  }

 private:
  void SkipSpace() {
    while (!rest_.empty() &&
           (rest_.front() == ' ' || rest_.front() == '\n' || rest_.front() == '\r' || rest_.front() == '\t')) {
      rest_.remove_prefix(1);
    }
  }

  // A number, true, false or null.
  bool SkipWord() {
    const auto end = std::ranges::find_if_not(
        rest_, [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '+' || c == '.'; });
    const size_t size = static_cast<size_t>(end - rest_.begin());
    rest_.remove_prefix(size);
    return size > 0;
  }

  std::string_view rest_;
};

// What a delta says, and under which names.
struct Pieces {
  // Empty where there is none, or null.
  std::string_view content;
  std::string_view reasoning_content;
  std::string_view reasoning;
};

bool IsText(std::string_view string) { return string.size() > 2; }

// A delta with a content or a thought and, at most, a role and the thought's details, which nobody reads; anything else
// in it must be null.
bool TakeDelta(Cursor& cursor, Pieces& pieces) {
  const auto take = [&](std::string_view& piece) {
    return piece.empty() && (cursor.TakeWord("null") || cursor.TakeString(piece));
  };
  return cursor.TakeObject([&](std::string_view key) {
    if (key == "\"content\"") return take(pieces.content);
    if (key == "\"reasoning_content\"") return take(pieces.reasoning_content);
    if (key == "\"reasoning\"") return take(pieces.reasoning);
    return cursor.TakeWord("null") || ((key == "\"role\"" || key == "\"reasoning_details\"") && cursor.Skip());
  });
}

bool TakeChoice(Cursor& cursor, Pieces& pieces) {
  return cursor.TakeObject([&](std::string_view key) {
    if (key == "\"delta\"") return TakeDelta(cursor, pieces);
    if (key == "\"index\"") return cursor.TakeWord("0");
    if (key == "\"finish_reason\"" || key == "\"message\"") return cursor.TakeWord("null");
    return cursor.Skip();
  });
}

// Neither escapes nor anything but ASCII.
bool IsPlain(std::string_view text) {
  return std::ranges::all_of(text, [](unsigned char c) { return c >= 0x20 && c < 0x80 && c != '\\'; });
}

}  // namespace

std::optional<DeltaPiece> PlainDelta(std::string_view chunk) {
  Cursor cursor(chunk);
  Pieces pieces;
  const bool plain = cursor.TakeObject([&](std::string_view key) {
    if (key == "\"choices\"") return cursor.Take('[') && TakeChoice(cursor, pieces) && cursor.Take(']');
    if (key == "\"usage\"" || key == "\"error\"") return cursor.TakeWord("null");
    return cursor.Skip();
  });
  if (!plain || !cursor.AtEnd()) return std::nullopt;
  const bool first = IsText(pieces.reasoning_content), second = IsText(pieces.reasoning);
  // The same under two names, or an answer and a thought at once: the parser knows what counts.
  if (first + second + IsText(pieces.content) > 1) return std::nullopt;
  if (first || second) return DeltaPiece{first ? pieces.reasoning_content : pieces.reasoning, true};
  if (!pieces.content.empty()) return DeltaPiece{pieces.content, false};
  // No text at all: an empty thought says as much as an empty answer.
  const std::string_view thought = pieces.reasoning_content.empty() ? pieces.reasoning : pieces.reasoning_content;
  return thought.empty() ? std::nullopt : std::optional(DeltaPiece{thought, true});
}

std::optional<std::string_view> PlainText(std::string_view json_string) {
  const std::string_view text = json_string.substr(1, json_string.size() - 2);
  return IsPlain(text) ? std::optional(text) : std::nullopt;
}

void RepeatedDelta::Learn(std::string_view chunk, const DeltaPiece& piece) {
  const size_t begin = static_cast<size_t>(piece.string.data() - chunk.data()) + 1;
  before_ = chunk.substr(0, begin);
  after_ = chunk.substr(begin + piece.string.size() - 2);
  thought_ = piece.thought;
}

std::optional<std::string_view> RepeatedDelta::Text(std::string_view chunk) const {
  if (before_.empty() || chunk.size() < before_.size() + after_.size()) return std::nullopt;
  if (!chunk.starts_with(before_) || !chunk.ends_with(after_)) return std::nullopt;
  chunk.remove_prefix(before_.size());
  chunk.remove_suffix(after_.size());
  // A quotation mark would end the string within the text.
  return IsPlain(chunk) && chunk.find('"') == std::string_view::npos ? std::optional(chunk) : std::nullopt;
}

}  // namespace flair::llm
