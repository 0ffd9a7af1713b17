// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session/embedded_documents.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <vector>

#include "cli/explain/layout_note.h"
#include "cli/input/artifact_file.h"
#include "cli/output/report_text.h"
#include "language_worker/handbook/loading/load_handbook.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

v1::ObjectKind KindOf(language::hb::FurnitureKind kind) {
  switch (kind) {
    case language::hb::FURNITURE_KIND_WALL:
      return v1::OBJECT_KIND_WALL;
    case language::hb::FURNITURE_KIND_CEILING:
      return v1::OBJECT_KIND_CEILING;
    case language::hb::FURNITURE_KIND_SURFACE:
      return v1::OBJECT_KIND_SURFACE;
    default:
      return v1::OBJECT_KIND_FLOOR;
  }
}

// The handbook's classes, in their usual sizes.
absl::StatusOr<std::vector<v1::FurnitureOffer>> Offers(const StageChoice& stages) {
  const std::vector<std::filesystem::path> overlays(stages.handbooks.begin(), stages.handbooks.end());
  ASSIGN_OR_RETURN(const auto handbook, language::LoadHandbook(language::DefaultHandbookFolder(), overlays));
  std::vector<v1::FurnitureOffer> offers;
  for (const language::hb::Furniture& furniture : handbook->contents().furniture()) {
    v1::FurnitureOffer& offer = offers.emplace_back();
    offer.set_group(furniture.category());
    v1::Object& object = *offer.mutable_object();
    object.set_name(furniture.name());
    object.set_category(furniture.category());
    object.set_kind(KindOf(furniture.kind()));
    object.set_role(object.kind() == v1::OBJECT_KIND_FLOOR && !furniture.walk_over() ? v1::OBJECT_ROLE_SECONDARY
                                                                                     : v1::OBJECT_ROLE_TERTIARY);
    object.set_width_m(furniture.width_m().typical());
    object.set_depth_m(furniture.depth_m().typical());
    object.set_height_m(furniture.height_m().typical());
    object.set_elevation_m(furniture.elevation_m());
    object.set_walk_over(furniture.walk_over());
    object.set_round(furniture.round());
  }
  return offers;
}

absl::StatusOr<v1::Artifact> ReadUpload(const std::string& bytes) {
  // Its ending is not known: the bytes say what it is.
  ASSIGN_OR_RETURN(ArtifactFile file, ParseArtifactFile("file", bytes));
  RETURN_IF_ERROR(file.whole);
  RETURN_IF_ERROR(file.good);
  return std::move(file.artifact);
}

absl::StatusOr<session::DocumentParts> Parts(const StageChoice& stages) {
  session::DocumentParts parts;
  ASSIGN_OR_RETURN(parts.furniture, Offers(stages));
  parts.read_file = ReadUpload;
  parts.not_as_asked = NotAsAsked;
  parts.note_json = [](const v1::SolvedLayout& layout,
                       const v1::ConstraintCatalog& catalog) -> absl::StatusOr<std::string> {
    ASSIGN_OR_RETURN(const Note note, MakeLayoutNote(layout, catalog));
    return NoteJson(note);
  };
  parts.note_text = [](const v1::SolvedLayout& layout,
                       const v1::ConstraintCatalog& catalog) -> absl::StatusOr<std::string> {
    ASSIGN_OR_RETURN(const Note note, MakeLayoutNote(layout, catalog));
    return NoteText(note, {.all = true});
  };
  return parts;
}

int stop_pipe[2] = {-1, -1};
void OnStop(int) {
  const ssize_t ignored = ::write(stop_pipe[1], "s", 1);
  (void)ignored;
}

}  // namespace

absl::StatusOr<std::unique_ptr<EmbeddedDocuments>> EmbeddedDocuments::Open(const OptionalLlm& llm,
                                                                           const StageChoice& stages) {
  std::unique_ptr<EmbeddedDocuments> opened(new EmbeddedDocuments());
  const std::string store = DefaultStorePath();
  opened->folder_ = store + "/documents";
  ASSIGN_OR_RETURN(opened->services_, EmbeddedServices::Start(store, llm, stages));
  const orchestrator::StageChannels& channels = opened->services_->stages();
  ASSIGN_OR_RETURN(session::DocumentParts parts, Parts(stages));
  ASSIGN_OR_RETURN(opened->documents_, session::Documents::Open(opened->folder_,
                                                                {.orchestrator = opened->services_->orchestrator(),
                                                                 .translator = channels.translator.channel,
                                                                 .optimizer = channels.optimizer.channel,
                                                                 .renderer = channels.renderer.channel},
                                                                std::move(parts)));
  return opened;
}

absl::StatusOr<int> StopDescriptor() {
  if (stop_pipe[0] < 0) {
    if (::pipe2(stop_pipe, O_CLOEXEC) != 0) return absl::InternalError("no pipe for signals");
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) std::signal(number, OnStop);
  }
  return stop_pipe[0];
}

}  // namespace flair::cli
