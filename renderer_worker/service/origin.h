// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "flair/v1/solved_layout.pb.h"
#include "renderer_worker/images/image_writer.h"

namespace flair::renderer {

// What a file says of where it comes from. Nothing that differs between two runs: no time, no machine.
struct Origin {
  std::string job_id;
  std::string brief_text;
  std::optional<int64_t> brief_seed;
  std::string layout_sha256;  // of the layout's canonical bytes, lower-case hex
};

// Of a RenderRequest or an ExportSceneRequest.
template <typename Request>
Origin OriginOf(const Request& request);

// Title, Software, and what is known of the origin as "flair:job_id", "flair:brief", "flair:seed",
// "flair:layout_sha256".
ImageMetadata MetadataOf(const Origin& origin, const std::string& title, const std::string& software);

// What the room is called, such as "A bedroom for a vampire."; "Room" when it has no name.
std::string TitleOf(const v1::SolvedLayout& layout);

}  // namespace flair::renderer
