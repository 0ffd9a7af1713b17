// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "flair/v1/object_list.pb.h"

// What kinds of furniture are told apart when they are drawn, modelled and counted. Thread-safe; nothing here fails.
namespace flair::renderer {

// Every class, sorted by name.
std::span<const std::string_view> FurnitureClasses();

// Number of a class for pictures of classes: from 1, the same in every version; 0 for a name that is no class.
int ClassIdOf(std::string_view class_name);

// The class that free text names, such as "adjustable dumbbell set" -> "weights"; empty when no word is telling. The
// last telling word wins ("desk lamp" is a lamp), whole phrases before words ("chest of drawers").
std::string_view ClassFromWords(std::string_view text);

// The class that `object` is shown as: what the words of its name call for, else its category, else its id; "box" when
// none of them is telling. What carries it decides between classes of the same name: a lamp on the ceiling is a
// pendant.
std::string_view ClassOf(const v1::Object& object);

}  // namespace flair::renderer
