// SPDX-License-Identifier: GPL-3.0-or-later
// Ways of writing a model's answers, and whole designs with a model that has them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "nlohmann/json.hpp"

namespace flair::testing {

using nlohmann::ordered_json;

// A way of writing an answer, and whether it has to be asked about again.
struct Deviation {
  std::string name;
  std::function<std::string(const ordered_json&)> write;
  bool asks = false;
};

using TextEdit = std::function<std::string(const std::string&)>;
// Replaces a member by one or more others.
using MemberEdit = std::function<void(const std::string& key, const ordered_json& value, ordered_json& object)>;

// A copy with every member of every object edited.
ordered_json Edited(const ordered_json& value, const MemberEdit& edit);

ordered_json WithKeys(const ordered_json& answer, const TextEdit& key);

// Of members whose key ends so.
ordered_json WithNumbers(const ordered_json& answer, const std::function<ordered_json(double)>& number,
                         const std::string& ending = "_m");

ordered_json WithNulls(const ordered_json& answer, const ordered_json& null);

// Of members with these keys.
ordered_json WithTexts(const ordered_json& answer, const std::vector<std::string>& keys, const TextEdit& text);

// Width, depth and height of an object in one member.
ordered_json WithSize(const ordered_json& answer,
                      const std::function<void(const std::vector<double>&, ordered_json&)>& write);

std::string Replaced(std::string text, const std::string& from, const std::string& to);
std::string Upper(std::string text);
// "Double Bed" of "double_bed".
std::string Title(std::string text);
// As JSON.
std::string Number(double number);
std::string Centimetres(double metres);

// Designs a room with a model that deviates so in every answer, and answers well when it is asked again: nothing is
// lost, and it is asked again only where it has to be.
void ExpectWholeDesign(const Deviation& deviation);

}  // namespace flair::testing
