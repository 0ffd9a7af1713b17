// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/handbook.h"

#include <utility>

#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {

Handbook::Handbook(hb::Handbook contents, std::string version)
    : contents_(std::move(contents)), version_(std::move(version)) {
  for (const auto& item : contents_.furniture()) furniture_.emplace(item.name(), &item);
  for (const auto& item : contents_.styles()) styles_.emplace(item.name(), &item);
  for (const auto& item : contents_.colours()) {
    colours_.emplace(item.name(), &item);
    for (const auto& synonym : item.synonyms()) colours_.emplace(synonym, &item);
  }
  for (const auto& item : contents_.archetypes()) {
    archetypes_.emplace(item.name(), &item);
    // That of an overlay comes first.
    if (fallback_ == nullptr || (item.fallback() && !fallback_->fallback())) fallback_ = &item;
  }
  vocabulary_ = std::make_shared<const Vocabulary>(*this);
}

}  // namespace flair::language
