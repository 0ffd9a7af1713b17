// SPDX-License-Identifier: GPL-3.0-or-later
// The account of a run for people, for programs and for the documentation.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/contract/suite.h"

namespace flair::contract {

// What is put to which test: service, address, program, claims. One line.
std::string HeadText(const Stage& stage, const Target& target);
// One line, and for what is broken three more.
std::string ResultText(const Result& result);
// One line: how many are kept, broken and skipped, and how long it took.
std::string SummaryText(std::span<const Result> results);
int BrokenCount(std::span<const Result> results);

std::string ResultsJson(const Stage& stage, const Target& target, std::span<const Result> results);

// What the stage promises, without a server: as a table for people, and as a section of docs/contract.md.
std::string ListText(const Stage& stage, std::span<const Check> checks);
std::string ListMarkdown(const Stage& stage, std::span<const Check> checks);
std::string ListJson(const Stage& stage, std::span<const Check> checks);

}  // namespace flair::contract
