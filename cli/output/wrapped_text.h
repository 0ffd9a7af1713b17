// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace flair::cli {

// The width in columns of a terminal: bytes that begin a character, which is right for the letters and signs that
// Flair writes itself.
size_t ColumnsOf(std::string_view text);

// Lines of at most `width` columns, each after the first begun with `indent`; `column` is where the first begins.
// Words longer than that stand alone, and figures stay with their unit.
std::string Wrapped(std::string_view text, size_t width, std::string_view indent, size_t column = 0);

// Columns that text on standard output should fit: those of the terminal, at most 110, at least 60; 80 where there is
// none.
size_t TextWidth();

}  // namespace flair::cli
