// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/layout_remarks.h"

#include "fmt/format.h"

namespace flair::cli {

std::string LayoutRemarks(const v1::SolvedLayout& layout) {
  std::string text;
  for (const v1::Diagnostic& diagnostic : layout.diagnostics()) {
    text += fmt::format("{:<11}{}\n", "remark", diagnostic.message());
  }
  for (const v1::Contradiction& contradiction : layout.contradictions()) {
    text += fmt::format("{:<11}{}\n", "clash", contradiction.explanation());
  }
  return text;
}

}  // namespace flair::cli
