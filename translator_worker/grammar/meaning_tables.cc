// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "absl/strings/str_split.h"
#include "english/language.h"
#include "translator_worker/grammar/meanings.h"
#include "translator_worker/grammar/rules/shared.h"

namespace flair::translator {

Words Split(std::string_view text, char separator) {
  return absl::StrSplit(std::string(text), separator, absl::SkipEmpty());
}

Condition::Condition(std::string_view text) {
  denied = text.front() == '!';
  if (denied) text.remove_prefix(1);
  const size_t end = std::min(text.find_first_of(":=."), text.size());
  subject = text.substr(0, end);
  if (end == text.size()) return;
  about = text[end];
  const size_t values_at = about == '.' ? text.find('=') : end;
  if (values_at != std::string_view::npos) values = Split(text.substr(values_at + 1), '|');
}

Template::Template(std::string_view text) {
  for (const std::string& word : Split(text, ' ')) {
    const size_t equals = word.find('=');
    if (equals == std::string::npos) {
      type = word;
      continue;
    }
    const bool required = word[equals + 1] == '!';
    arguments.push_back({word.substr(0, equals), Split(word.substr(equals + (required ? 2 : 1)), '/'), required});
  }
}

Case::Case(const english::v1::Case& from) : data(&from) {
  for (const std::string& test : Split(from.when(), ' ')) tests.emplace_back(test);
  for (const std::string& call : from.calls()) {
    std::vector<Template>& alternatives = calls.emplace_back();
    for (const std::string& one : Split(call, '|')) alternatives.emplace_back(one);
  }
}

const std::map<std::string, Table, std::less<>>& Tables() {
  static const auto* const tables = [] {
    auto* const made = new std::map<std::string, Table, std::less<>>;
    for (const english::v1::Meaning& meaning : english::Language::Get().data().meanings()) {
      Table& table = (*made)[meaning.name()];
      table.movers = Split(meaning.movers(), ' ');
      table.targets = Split(meaning.targets(), ' ');
      for (const english::v1::Case& one : meaning.first()) table.first.emplace_back(one);
      for (const english::v1::Case& one : meaning.cases()) table.cases.emplace_back(one);
    }
    return made;
  }();
  return *tables;
}

const std::map<std::string_view, Builder>& Procedures() {
  static const auto* const procedures = [] {
    auto* const made = new std::map<std::string_view, Builder>;
    for (const auto family : {&GroupProcedures, &SpaceProcedures}) {
      for (const auto& [name, build] : family()) made->emplace(name, build);
    }
    return made;
  }();
  return *procedures;
}

std::vector<std::string> UnknownMeanings() {
  std::set<std::string> unknown;
  const auto use = [&](const std::string& name) {
    if (!name.empty() && !Tables().contains(name) && !Procedures().contains(name)) unknown.insert(name);
  };
  for (const english::v1::Frame& frame : english::Language::Get().data().frames()) use(frame.meaning());
  for (const auto& [name, table] : Tables()) {
    for (const Case& one : table.first) use(one.data->as());
    for (const Case& one : table.cases) use(one.data->as());
  }
  return {unknown.begin(), unknown.end()};
}

}  // namespace flair::translator
