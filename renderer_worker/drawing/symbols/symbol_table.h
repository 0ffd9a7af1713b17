// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "flair/v1/object_list.pb.h"
#include "renderer_worker/drawing/symbols/symbol.h"

namespace flair::renderer {

// Every symbol, sorted by category.
std::span<const Symbol> Symbols();

// The symbol of a category; null when there is none.
const Symbol* FindSymbol(std::string_view category);

// The symbol that `object` is drawn with: what the words of its name call for, else its category. The last telling word
// wins ("desk lamp" is a lamp), whole phrases before words ("chest of drawers"). Never null: a plain box.
const Symbol* SymbolFor(const v1::Object& object);

// The category that free text names, such as "adjustable dumbbell set" -> "weights"; empty when no word is telling.
std::string_view CategoryFromWords(std::string_view text);

}  // namespace flair::renderer
