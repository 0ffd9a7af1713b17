// SPDX-License-Identifier: GPL-3.0-or-later
// The data files of a handbook as they were read, and what is wrong in them.
#pragma once

#include <google/protobuf/text_format.h>

#include <memory>
#include <string>
#include <vector>

#include "language_worker/handbook/loading/load_handbook.h"

namespace flair::language {

struct HandbookFile {
  std::string name;  // in messages: relative to the base folder; of an overlay with the folder as it was given
  std::string text;
  bool overlay = false;
  bool last = false;  // of the last folder
  hb::Handbook part;
  std::unique_ptr<google::protobuf::TextFormat::ParseInfoTree> lines =
      std::make_unique<google::protobuf::TextFormat::ParseInfoTree>();
};

// Adds what is wrong or worth a note: names given twice in one folder or missing, names of classes, rooms, styles,
// zones, colours and materials that do not exist, sizes out of order, unknown placeholders, colours that are not
// #RRGGBB; and lists the sentences.
void CheckFiles(const std::vector<HandbookFile>& files, HandbookFindings& findings);

}  // namespace flair::language
