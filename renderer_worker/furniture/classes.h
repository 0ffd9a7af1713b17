// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "flair/v1/object_list.pb.h"
#include "renderer_worker/furniture/furniture.pb.h"

// The classes of furniture, which plans, views, GLB files and the search for assets share: one record each in
// classes.textproto. Thread-safe; nothing here fails.
namespace flair::renderer {

// classes.textproto and materials.textproto together, read at the first call.
const FurnitureData& Furniture();

// The record of a class; that of "box" for a name that is no class.
const FurnitureClass& ClassNamed(std::string_view class_name);

// Number of a class for pictures of classes: from 1, the same in every version; 0 for a name that is no class.
int ClassIdOf(std::string_view class_name);

// The class whose word is the head noun of a name, such as "adjustable dumbbell set" -> "weights"; empty where no class
// has it. The head noun is the last word ("desk lamp" is a lamp), with those before it where the phrase is known, of
// what comes before the first comma, bracket or small word ("wardrobe with mirror").
std::string_view ClassFromWords(std::string_view name);

// The class that `object` is shown as: by its name, else by its category and its id where they name a class that is not
// rough; "box", a plain block, where none of them does. What carries it decides between classes of the same name: a
// lamp on the ceiling is a pendant.
std::string_view ClassOf(const v1::Object& object);

// How high things lie that are put on a piece of furniture of our making, metres above its underside: on the mattress
// of a bed, the seat of a sofa, the top of a dressing table below its mirror. The piece's height, (0, inf), for all
// others.
float RestHeightOf(std::string_view class_name, float height_m);

}  // namespace flair::renderer
