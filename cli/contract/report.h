// SPDX-License-Identifier: GPL-3.0-or-later
// The account of a run for people, for programs and for the documentation.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/contract/check.h"

namespace flair::contract {

// What is put to which test: service, address, program, claims. One line.
std::string HeadText(const Stage& stage, const Target& target);
// One line, and for what is broken three more.
std::string ResultText(const Result& result);
// One line: how many are kept, broken and skipped, and how long it took.
std::string SummaryText(std::span<const Result> results);
int BrokenCount(std::span<const Result> results);

std::string ResultsJson(const Stage& stage, const Target& target, std::span<const Result> results);

// What the stage promises, without a server: for people, as a section of docs/contract.md (below its head), as JSON.
std::string ListText(const Stage& stage, std::span<const Check> checks);
inline constexpr char kMarkdownHead[] =
    "<!-- Made by `flair contract --list --markdown`; do not edit. -->\n"
    "# What each stage promises\n\n"
    "`flair contract STAGE --target HOST:PORT` puts every line to a server, in any language, and says which it keeps;\n"
    "[replace-a-stage.md](replace-a-stage.md) tells how to put such a server in a stage's place.\n\n";
std::string ListMarkdown(const Stage& stage, std::span<const Check> checks);
std::string ListJson(std::span<const Stage> stages);

}  // namespace flair::contract
