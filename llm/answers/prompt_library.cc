// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/prompt_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::llm {
namespace {

namespace fs = std::filesystem;

absl::StatusOr<std::string> ReadFile(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) return Unavailable("cannot read prompt file {}", path.string());
  return text.str();
}

std::string WithoutRemarks(const std::string& text) {
  std::istringstream lines(text);
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    // A remark leaves its line empty-handed, so that faults keep their line numbers.
    if (!line.starts_with("%%")) kept += line;
    kept += '\n';
  }
  return kept;
}

// The text without empty lines at its ends.
std::string Trimmed(const std::string& text) {
  const size_t first = text.find_first_not_of(" \n\t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \n\t") - first + 1);
}

// A placeholder in a text: [start, end) with its braces; start is npos when there is no other.
struct Placeholder {
  size_t start = std::string::npos;
  size_t end = std::string::npos;
  std::string name;
};

Placeholder NextPlaceholder(std::string_view text, size_t from) {
  Placeholder next;
  const size_t open = text.find("{{", from);
  const size_t close = open == std::string_view::npos ? open : text.find("}}", open);
  if (close == std::string_view::npos) return next;
  next.start = open;
  next.end = close + 2;
  next.name = std::string(text.substr(open + 2, close - open - 2));
  return next;
}

std::string Listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "{{" : ", {{") + name + "}}";
  return list.empty() ? "none" : list;
}

absl::Status Check(const fs::path& path, const std::string& text, const PromptSpec& spec) {
  if (Trimmed(text).empty()) return InvalidArgument("{}: the prompt is empty", path.string());
  try {
    (void)nlohmann::json(text).dump();
  } catch (const nlohmann::json::exception&) {
    return InvalidArgument("{}: the prompt is no UTF-8 text", path.string());
  }
  std::vector<std::string> used;
  for (Placeholder next = NextPlaceholder(text, 0); next.start != std::string::npos;
       next = NextPlaceholder(text, next.end)) {
    const auto& known = spec.placeholders;
    if (std::ranges::find(known, next.name) == known.end()) {
      const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(next.start), '\n');
      return InvalidArgument("{}:{}: {{{{{}}}}} is not a placeholder of this prompt; it has {}", path.string(), line,
                             next.name, Listed(known));
    }
    used.push_back(next.name);
  }
  for (const std::string& name : spec.required) {
    if (std::ranges::find(used, name) != used.end()) continue;
    return InvalidArgument("{}: {{{{{}}}}} is not in the text", path.string(), name);
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<PromptLibrary> PromptLibrary::Load(const fs::path& installed, const fs::path& overrides,
                                                  const std::vector<PromptSpec>& specs) {
  for (const fs::path& folder : {installed, overrides}) {
    std::error_code error;
    if (folder.empty() || fs::is_directory(folder, error)) continue;
    return NotFound("prompts folder {} is not a folder", folder.string());
  }
  PromptLibrary library;
  std::string all;
  for (const PromptSpec& spec : specs) {
    std::error_code error;
    fs::path path = overrides / (spec.name + ".txt");
    if (overrides.empty() || !fs::exists(path, error)) path = installed / (spec.name + ".txt");
    if (!fs::exists(path, error)) return NotFound("prompt {} is missing", path.string());
    ASSIGN_OR_RETURN(const std::string text, ReadFile(path));
    const std::string kept = WithoutRemarks(text);
    RETURN_IF_ERROR(Check(path, kept, spec));
    library.texts_[spec.name] = Trimmed(kept);
  }
  for (const auto& [name, text] : library.texts_) all += fmt::format("{}\n{}\n{}", name, text.size(), text);
  library.version_ = runtime::Sha256Hex(all).substr(0, 16);
  return library;
}

std::string PromptLibrary::Fill(std::string_view name, const PromptValues& values) const {
  const auto found = texts_.find(name);
  if (found == texts_.end()) return "";
  const std::string& text = found->second;
  std::string filled;
  size_t from = 0;
  for (Placeholder next = NextPlaceholder(text, 0); next.start != std::string::npos;
       next = NextPlaceholder(text, next.end)) {
    filled += text.substr(from, next.start - from);
    if (const auto value = values.find(next.name); value != values.end()) filled += value->second;
    from = next.end;
  }
  return filled + text.substr(from);
}

std::string QuoteData(std::string_view text) {
  const std::string quoted =
      nlohmann::json(std::string(text)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  std::string data;
  for (const char c : quoted) {
    if (c == '<') {
      data += "\\u003c";
    } else if (c == '>') {
      data += "\\u003e";
    } else {
      data += c;
    }
  }
  return data;
}

}  // namespace flair::llm
