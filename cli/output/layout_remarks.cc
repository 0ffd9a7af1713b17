// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/layout_remarks.h"

#include "fmt/format.h"

namespace flair::cli {
namespace {

constexpr int kListedDrops = 20;

}  // namespace

std::string LayoutRemarks(const v1::SolvedLayout& layout) {
  std::string text;
  for (const v1::Diagnostic& diagnostic : layout.diagnostics()) {
    text += fmt::format("{:<11}{}\n", "remark", diagnostic.message());
  }
  int dropped = 0;
  for (const v1::EdgeOutcome& outcome : layout.edge_outcomes()) {
    if (outcome.status() != v1::OUTCOME_STATUS_DROPPED || ++dropped > kListedDrops) continue;
    text += fmt::format("{:<11}{}: {}\n", "dropped", outcome.edge_id(), outcome.reason());
  }
  if (dropped > kListedDrops) text += fmt::format("{:<11}{} more\n", "dropped", dropped - kListedDrops);
  for (const v1::Contradiction& contradiction : layout.contradictions()) {
    text += fmt::format("{:<11}{}\n", "clash", contradiction.explanation());
  }
  return text;
}

}  // namespace flair::cli
