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

// The symbol of a class of furniture (furniture/classes.h). Never null: a plain box.
const Symbol* SymbolOfClass(std::string_view class_name);

// The symbol that `object` is drawn with: that of its class.
const Symbol* SymbolFor(const v1::Object& object);

}  // namespace flair::renderer
