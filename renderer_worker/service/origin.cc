// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/service/origin.h"

#include <fmt/format.h>

#include "flair/v1/renderer_service.pb.h"
#include "worker_runtime/files/files.h"

namespace flair::renderer {

template <typename Request>
Origin OriginOf(const Request& request) {
  Origin origin{.job_id = request.job_id(), .brief_text = request.brief_text(), .brief_seed = {}, .layout_sha256 = {}};
  if (request.has_brief_seed()) origin.brief_seed = request.brief_seed();
  origin.layout_sha256 = runtime::Sha256Hex(runtime::CanonicalBytes(request.solved_layout()));
  return origin;
}

template Origin OriginOf(const v1::RenderRequest&);
template Origin OriginOf(const v1::ExportSceneRequest&);

ImageMetadata MetadataOf(const Origin& origin, const std::string& title, const std::string& software) {
  ImageMetadata metadata = {{"Title", title}, {"Software", software}};
  if (!origin.job_id.empty()) metadata.emplace_back("flair:job_id", origin.job_id);
  if (!origin.brief_text.empty()) metadata.emplace_back("flair:brief", origin.brief_text);
  if (origin.brief_seed) metadata.emplace_back("flair:seed", fmt::format("{}", *origin.brief_seed));
  metadata.emplace_back("flair:layout_sha256", origin.layout_sha256);
  return metadata;
}

std::string TitleOf(const v1::SolvedLayout& layout) {
  const v1::Room& room = layout.graph().room();
  if (!room.title().empty()) return room.title();
  return room.room_type().empty() ? "Room" : room.room_type();
}

}  // namespace flair::renderer
