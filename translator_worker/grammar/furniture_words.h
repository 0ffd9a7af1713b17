// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flair::translator {

// Names for the same thing: each group is a list of phrases, singular, such as {"nightstand", "bedside table"}.
const std::vector<std::vector<std::string>>& FurnitureSynonyms();

// Further names of furniture, so that a sentence about one that the room lacks is recognised as such.
const std::vector<std::string>& FurnitureNames();

// "shelves" -> "shelf", "boxes" -> "box", "chairs" -> "chair"; other words unchanged.
std::string Singular(std::string_view word);

}  // namespace flair::translator
