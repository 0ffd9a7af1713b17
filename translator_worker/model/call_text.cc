// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "llm/answers/read_answer.h"
#include "translator_worker/model/prompt_texts.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::translator {
namespace {

constexpr const char* kSpaces = " \t\r\n";

// Opening and closing marks of a quotation.
struct Quotes {
  std::string_view open, close;
};
constexpr std::array<Quotes, 3> kQuotes = {{{"\"", "\""}, {"'", "'"}, {"`", "`"}}};

std::string_view Trimmed(std::string_view text, std::string_view marks = kSpaces) {
  const size_t first = text.find_first_not_of(marks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(marks) - first + 1);
}

bool IsOpening(char c) { return c == '(' || c == '[' || c == '{'; }
bool IsClosing(char c) { return c == ')' || c == ']' || c == '}'; }

// The text without the quotation marks around it.
std::string_view Unquoted(std::string_view text) {
  text = Trimmed(text);
  for (const Quotes& quotes : kQuotes) {
    if (!text.starts_with(quotes.open)) continue;
    text.remove_prefix(quotes.open.size());
    if (text.ends_with(quotes.close)) text.remove_suffix(quotes.close.size());
    return Trimmed(text);
  }
  return text;
}

// Length of the quotation at the start; 0 when there is none, or no end of it.
size_t QuotationLength(std::string_view text) {
  for (const Quotes& quotes : kQuotes) {
    if (!text.starts_with(quotes.open)) continue;
    const size_t end = text.find(quotes.close, quotes.open.size());
    return end == std::string_view::npos ? 0 : end + quotes.close.size();
  }
  return 0;
}

// Length of what stands before the first of `marks` that is in no brackets and no quotation; all when there is none. A
// closing bracket without its opening one ends it too.
size_t LengthUntil(std::string_view text, std::string_view marks) {
  int depth = 0;
  bool begins = true;  // quotations only where a word begins: "the bed's"
  for (size_t i = 0; i < text.size(); ++i) {
    const size_t quotation = begins ? QuotationLength(text.substr(i)) : 0;
    if (quotation > 0) {
      i += quotation - 1;
      begins = false;
      continue;
    }
    const char c = text[i];
    if (depth == 0 && (marks.find(c) != std::string_view::npos || IsClosing(c))) return i;
    if (IsOpening(c)) ++depth;
    if (IsClosing(c)) --depth;
    begins = !((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'));
  }
  return text.size();
}

std::vector<std::string_view> Divide(std::string_view text, std::string_view marks) {
  std::vector<std::string_view> parts;
  while (!Trimmed(text).empty()) {
    const size_t length = LengthUntil(text, marks);
    if (const std::string_view part = Trimmed(text.substr(0, length)); !part.empty()) parts.push_back(part);
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return parts;
}

// Whether a text begins with a word for no call; takes it off.
bool TakeNone(std::string_view& text) {
  const size_t end = std::min(text.find_first_of(std::string("(:-,;. \t")), text.size());
  const std::string word = llm::Bare(text.substr(0, end));
  if (word != "none" && word != "null") return false;
  text.remove_prefix(end);
  return true;
}

// A comment behind a call, or a mark of its end.
bool IsIdle(std::string_view rest) { return rest.empty() || rest[0] == '#' || rest.starts_with("//"); }

// Takes what stands between calls.
void SkipBetween(std::string_view& text) { text = Trimmed(Trimmed(text, " \t,;.&)]}`\"'")); }

// One argument in the notation: "sofa", "target=sofa", "objects: [a, b]".
WrittenArgument ReadArgumentText(std::string_view text) {
  WrittenArgument argument;
  // A name before "=" or ":".
  if (const size_t sign = LengthUntil(text, "=:"); sign < text.size() && !IsClosing(text[sign])) {
    argument.name = std::string(Unquoted(text.substr(0, sign)));
    text = text.substr(sign + 1);
  }
  text = Trimmed(text);
  argument.in_brackets = !text.empty() && IsOpening(text[0]);
  if (!argument.in_brackets) {
    argument.values.emplace_back(Unquoted(text));
    return argument;
  }
  text.remove_prefix(1);
  if (!text.empty() && IsClosing(text.back())) text.remove_suffix(1);
  for (const std::string_view value : Divide(text, ",;")) argument.values.emplace_back(Unquoted(value));
  return argument;
}

}  // namespace

absl::StatusOr<WrittenCalls> ReadCallText(std::string_view written) {
  std::string_view text = Trimmed(written, " \t\r\n`");
  while (text.starts_with("- ") || text.starts_with("* ")) text = Trimmed(text.substr(2));
  WrittenCalls read;
  if (text.empty()) read.none = true;
  while (!text.empty()) {
    if (TakeNone(text)) {
      read.none = true;
      read.why = std::string(Unquoted(Trimmed(text, " \t():;-.")));
      return read;
    }
    const size_t open = text.find('(');
    const std::string_view name = Unquoted(text.substr(0, std::min(open, text.size())));
    if (open == std::string_view::npos || name.empty() || name.size() > 100 || read.calls.size() == kMostCalls) {
      return InvalidArgument("{} is no call; one such as near(sofa, shelf) or none(why) would be right",
                             llm::Quoted(text));
    }
    text.remove_prefix(open + 1);
    const size_t length = LengthUntil(text, "");
    WrittenCall& call = read.calls.emplace_back();
    call.function = std::string(name);
    for (const std::string_view part : Divide(text.substr(0, length), ",;")) {
      call.arguments.push_back(ReadArgumentText(part));
    }
    text.remove_prefix(length);
    SkipBetween(text);
    if (IsIdle(text)) break;
  }
  return read;
}

}  // namespace flair::translator
