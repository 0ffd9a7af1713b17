// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"

namespace flair::language {

// Turns the ids that a model writes into its sentences, because it was shown them, into words: "double_bed" is "double
// bed", "nightstand_2" the "second nightstand", "window_1" a "window". Immutable, thread-safe.
class ObjectWords {
 public:
  ObjectWords(const v1::ObjectList& objects, const v1::Room& room);

  std::string InWords(const std::string& sentence) const;

 private:
  std::map<std::string, std::string, std::less<>> words_;
};

// "first" to "tenth", then "11th"; `number` counts from 0.
std::string Ordinal(size_t number);

}  // namespace flair::language
