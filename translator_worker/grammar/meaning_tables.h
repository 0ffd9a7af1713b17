// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of meanings.h, parsed.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "flair/english/v1/language.pb.h"
#include "translator_worker/grammar/composer.h"

namespace flair::translator {

using Words = std::vector<std::string>;

Words Split(std::string_view text, char separator);

// One condition of a case, "!mover.side=front|back".
struct Condition {
  bool denied = false;
  std::string subject;
  char about = 0;  // ':', '=', '.' for sides, or 0 for being there
  Words values;

  explicit Condition(std::string_view text);
};

// A call to be, "near object=A target=B".
struct Template {
  struct Argument {
    std::string name;
    Words values;  // the first that is not empty counts
    bool required = false;
  };
  std::string type;
  std::vector<Argument> arguments;

  explicit Template(std::string_view text);
};

struct Case {
  std::vector<Condition> tests;
  std::vector<std::vector<Template>> calls;  // of each the first that can be made
  const english::v1::Case* data;

  explicit Case(const english::v1::Case& from);
};

struct Table {
  Words movers;
  Words targets;
  std::vector<Case> first;
  std::vector<Case> cases;
};

// By name. Those of english::Language::Get(), made on first use.
const std::map<std::string, Table, std::less<>>& Tables();
// Meanings that are procedures, by name.
const std::map<std::string_view, Builder>& Procedures();

}  // namespace flair::translator
