// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/handbook.h"

#include <utility>

#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {

Handbook::Handbook(hb::Handbook contents, std::string version)
    : contents_(std::make_shared<const hb::Handbook>(std::move(contents))), version_(std::move(version)) {
  for (const auto& item : contents_->furniture()) furniture_.emplace(item.name(), &item);
  for (const auto& item : contents_->styles()) styles_.emplace(item.name(), &item);
  for (const auto& item : contents_->colours()) {
    colours_.emplace(item.name(), &item);
    for (const auto& synonym : item.synonyms()) colours_.emplace(synonym, &item);
  }
  for (const auto& item : contents_->archetypes()) {
    archetypes_.emplace(item.name(), &item);
    // That of an overlay comes first.
    if (fallback_ == nullptr || (item.fallback() && !fallback_->fallback())) fallback_ = &item;
  }
  vocabulary_ = std::make_shared<const Vocabulary>(*this);
}

Handbook::Handbook(const Handbook& base, std::vector<hb::Furniture> own)
    : contents_(base.contents_),
      own_(std::move(own)),
      version_(base.version_),
      furniture_(base.furniture_),
      archetypes_(base.archetypes_),
      styles_(base.styles_),
      colours_(base.colours_),
      fallback_(base.fallback_) {
  for (const hb::Furniture& furniture : own_) furniture_[furniture.name()] = &furniture;
  vocabulary_ = std::make_shared<const Vocabulary>(*base.vocabulary_, own_);
}

}  // namespace flair::language
