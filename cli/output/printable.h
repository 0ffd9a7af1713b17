// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace flair::cli {

// What a stranger wrote must not steer the terminal: control characters but line break and tab become spaces.
std::string Printable(std::string text);

// Line breaks and tabs, too: for a cell of a table.
std::string PrintableLine(std::string text);

// At most `columns` characters; what is longer ends in "…".
std::string Shortened(std::string_view text, size_t columns);

// Safe in a cell of a Markdown table.
std::string MarkdownCell(std::string text);

}  // namespace flair::cli
