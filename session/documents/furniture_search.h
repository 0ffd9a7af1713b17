// SPDX-License-Identifier: GPL-3.0-or-later
// Which furniture somebody looks for who types a few letters of it.
#pragma once

#include <string>
#include <vector>

#include "flair/v1/studio_service.pb.h"
#include "session/documents/documents.h"

namespace flair::session {

// The offers that words mean by their names or by others for them ("couch"), best first; all when there are no words.
// Behind them the rest of the best one's category: whoever looks for a picture may want a painting. Of `parts`.
std::vector<const v1::FurnitureOffer*> FoundFurniture(const DocumentParts& parts, const std::string& query);

}  // namespace flair::session
