// SPDX-License-Identifier: GPL-3.0-or-later
// What a translating model is told, as short lines of text.
#pragma once

#include <span>
#include <string>

#include "flair/v1/constraint_catalog.pb.h"
#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/translator_service.pb.h"

namespace flair::translator {

// One line a type: how it is called, what then holds, and an example where that says it in other words than the name.
// Names, parameters and defaults; never code.
std::string FunctionsText(std::span<const v1::ConstraintType* const> types);

// "4.00 x 5.00 m; walls north, east, ...; 1 door, 2 windows, 3 sockets".
std::string RoomText(const v1::Room& room);

std::string ZonesText(const v1::ZonePlan& zones);

// One line for equal objects that follow each other: ids, the name where the ids do not tell it, width and depth, zone,
// and where they are when not simply on the floor. Tertiaries only where the sentences are about them.
std::string ObjectsText(const v1::ObjectList& objects, std::span<const v1::Sentence* const> sentences);

// One line a sentence: id, and its text quoted as data; the ids of its subjects in a heading in brackets before it, and
// before all that follow with the same.
std::string SentencesText(std::span<const v1::Sentence* const> sentences);

}  // namespace flair::translator
