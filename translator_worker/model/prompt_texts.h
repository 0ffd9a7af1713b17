// SPDX-License-Identifier: GPL-3.0-or-later
// What a translating model is told, as short lines of text.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

struct Pass {
  v1::SentenceScope scope;
  // Name of the step, such as "translation.intra".
  std::string_view step;
  // Told to the model.
  std::string_view task;
};

inline constexpr std::array<Pass, 3> kPasses = {
    {{v1::SENTENCE_SCOPE_INTRA, "translation.intra", "These sentences are about one object and the room."},
     {v1::SENTENCE_SCOPE_INTER, "translation.inter", "These sentences are about objects among each other."},
     {v1::SENTENCE_SCOPE_TERTIARY, "translation.tertiary",
      "These sentences say where small things, rugs, lamps and wall pieces go."}}};

// The types that a pass is told of: those of the families that its sentences speak of, and of every family that is not
// one of ours, in the order of the catalogue, as far as the room has something to call them with: no lamps without a
// ceiling lamp. None is built in.
std::vector<const v1::ConstraintType*> TypesFor(const Pass& pass, const v1::TranslateRequest& request);

}  // namespace flair::translator
