// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "language_worker/handbook/reading/brief_facts.h"

namespace flair::language {

// "no tv", "without a desk", "no tv or desk", "a shower instead of a bathtub"; not "not near the bed", "no more than
// two chairs".
bool IsRefused(const std::vector<Token>& tokens, std::size_t i);

// A word alone refuses all of its kind: "no chairs" also the armchairs, "no lamps" those on tables and floor. Whether
// there are any.
bool RefuseKind(const Handbook& handbook, const std::vector<Token>& tokens, std::size_t i, BriefFacts& facts);

// "a bench if there is room", "perhaps a bench", "an optional bench". Words in `used` belong to something else.
bool IsOptional(const std::vector<Token>& tokens, const std::vector<bool>& used, std::size_t begin, std::size_t end);

// "only a bed and a wardrobe", "just a desk", "nothing but a sofa", "and nothing else".
bool AsksForNothingElse(const Handbook& handbook, const std::vector<Token>& tokens);

// "chair" of "dining chair".
std::string LastWord(const std::string& name);

}  // namespace flair::language
