// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <vector>

#include "cli/diff/artifact_difference.h"
#include "cli/output/artifact_text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"

namespace flair::cli {
namespace {

constexpr size_t kTitleWidth = 11;
constexpr size_t kSubjectWidth = 44;

// What things of a sort became, in order of telling; the sign stands before each.
struct Sort {
  Became became;
  const char* sign;
  const char* word;
};
constexpr Sort kSorts[] = {{Became::kAdded, "+", "added"},
                           {Became::kRemoved, "-", "removed"},
                           {Became::kChanged, "~", "changed"},
                           {Became::kBetter, "<", "better"},
                           {Became::kWorse, ">", "worse"}};

const Sort& SortOf(Became became) { return *std::ranges::find(kSorts, became, &Sort::became); }

// "objects    12 the same, 1 added, 2 changed".
std::string Heading(const Section& section) {
  std::vector<std::string> parts;
  if (!section.note.empty()) parts.push_back(section.note);
  if (section.same_count > 0) parts.push_back(fmt::format("{} the same", section.same_count));
  for (const Sort& sort : kSorts) {
    const auto count = std::ranges::count(section.changes, sort.became, &Change::became);
    if (count > 0) parts.push_back(fmt::format("{} {}", count, sort.word));
  }
  return fmt::format("{:<{}} {}\n", section.title, kTitleWidth, fmt::join(parts, ", "));
}

size_t Letters(const std::string& text) {
  return static_cast<size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

// Subjects in a column; words of long ones on a line of their own.
std::string Lines(const Section& section) {
  size_t width = 0;
  for (const Change& change : section.changes) {
    if (const size_t letters = Letters(change.subject); letters <= kSubjectWidth) width = std::max(width, letters);
  }
  std::string text;
  for (const Change& change : section.changes) {
    const size_t letters = Letters(change.subject);
    text += fmt::format("  {} {}", SortOf(change.became).sign, change.subject);
    if (!change.words.empty()) {
      text += letters > width ? "\n      " : std::string(width - letters + 2, ' ');
      text += change.words;
    }
    text += '\n';
  }
  return text;
}

std::string_view WordFor(Became became) { return SortOf(became).word; }

}  // namespace

std::string DifferenceText(const Difference& difference, const std::string& a, const std::string& b) {
  if (difference.content_is_same && difference.origin_is_same) {
    return fmt::format("{} and {} are the same {}\n", a, b, KindName(difference.kind));
  }
  std::string text = fmt::format("A {}\nB {}\n", a, b);
  if (difference.content_is_same) text += "the content is the same, byte for byte; what it was made by is not\n";
  std::string same;
  for (const Section& section : difference.sections) {
    if (section.changes.empty() && section.note.empty()) {
      same += fmt::format("{}{} {}", same.empty() ? "" : ", ", section.same_count, section.title);
    } else {
      text += Heading(section) + Lines(section);
    }
  }
  if (!same.empty()) text += fmt::format("{:<{}} {}\n", "the same", kTitleWidth, same);
  if (!difference.content_is_same && difference.IsEmpty()) {
    text += "nothing that matters differs; flair inspect --format json shows both\n";
  }
  return text;
}

std::string DifferenceJson(const Difference& difference, const std::string& a, const std::string& b) {
  nlohmann::json json = {{"kind", KindName(difference.kind)},
                         {"a", a},
                         {"b", b},
                         {"content_is_same", difference.content_is_same},
                         {"origin_is_same", difference.origin_is_same},
                         {"sections", nlohmann::json::array()}};
  for (const Section& section : difference.sections) {
    nlohmann::json changes = nlohmann::json::array();
    for (const Change& change : section.changes) {
      nlohmann::json entry = {{"became", WordFor(change.became)}, {"subject", change.subject}, {"words", change.words}};
      if (change.detail.is_object()) entry["detail"] = change.detail;
      changes.push_back(std::move(entry));
    }
    nlohmann::json entry = {
        {"title", section.title}, {"same_count", section.same_count}, {"changes", std::move(changes)}};
    if (!section.note.empty()) entry["note"] = section.note;
    json["sections"].push_back(std::move(entry));
  }
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace flair::cli
