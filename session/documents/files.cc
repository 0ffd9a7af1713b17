// SPDX-License-Identifier: GPL-3.0-or-later
// Documents as files.
#include <algorithm>
#include <utility>
#include <vector>

#include "absl/strings/ascii.h"
#include "cli/output/artifact_text.h"
#include "cli/output/tar_file.h"
#include "fmt/format.h"
#include "session/documents/documents.h"
#include "session/documents/furniture_list.h"
#include "session/documents/record.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using cli::OutputFile;
using runtime::CallContext;

// They travel as one message.
constexpr size_t kMostArchiveBytes = size_t{16} << 20;
// A sheet of A3 can be printed from its pixels.
constexpr int kPrintedDpi = 200;

// What a document is called as a file: "a-bedroom-for-two". A long one ends with a whole word.
std::string FileStemOf(const std::string& title) {
  constexpr size_t kMost = 60;
  std::string stem;
  for (const char c : title) {
    const char low = absl::ascii_tolower(static_cast<unsigned char>(c));
    if (absl::ascii_isalnum(static_cast<unsigned char>(low))) {
      stem += low;
    } else if (!stem.empty() && stem.back() != '-') {
      stem += '-';
    }
  }
  if (const size_t end = stem.rfind('-', kMost); stem.size() > kMost) {
    stem.resize(end == std::string::npos ? kMost : end);
  }
  while (stem.ends_with('-')) stem.pop_back();
  return stem.empty() ? "room" : stem;
}

struct Format {
  v1::DocumentFormat format;
  const char* ending;
  const char* media_type;
  const char* name;  // in the archive of everything; empty: it is not there
  v1::PreviewView view = v1::PREVIEW_VIEW_UNSPECIFIED;
  v1::PreviewFormat preview = v1::PREVIEW_FORMAT_UNSPECIFIED;
};
constexpr Format kFormats[] = {
    {v1::DOCUMENT_FORMAT_PLAN_PNG, ".png", "image/png", "plan.png", v1::PREVIEW_VIEW_PLAN, v1::PREVIEW_FORMAT_PNG},
    {v1::DOCUMENT_FORMAT_PLAN_SVG, ".svg", "image/svg+xml", "plan.svg", v1::PREVIEW_VIEW_PLAN, v1::PREVIEW_FORMAT_SVG},
    {v1::DOCUMENT_FORMAT_PLAN_PDF, ".pdf", "application/pdf", "plan.pdf", v1::PREVIEW_VIEW_PLAN,
     v1::PREVIEW_FORMAT_PDF},
    {v1::DOCUMENT_FORMAT_BIRDSEYE_PNG, "-birdseye.png", "image/png", "view-from-above.png", v1::PREVIEW_VIEW_BIRDSEYE,
     v1::PREVIEW_FORMAT_PNG},
    {v1::DOCUMENT_FORMAT_PERSPECTIVE_PNG, "-perspective.png", "image/png", "view-at-eye-level.png",
     v1::PREVIEW_VIEW_PERSPECTIVE, v1::PREVIEW_FORMAT_PNG},
    {v1::DOCUMENT_FORMAT_SCENE_GLB, ".glb", "model/gltf-binary", "model.glb"},
    {v1::DOCUMENT_FORMAT_REPORT, ".md", "text/markdown; charset=utf-8", "report.md"},
    {v1::DOCUMENT_FORMAT_FURNITURE_CSV, "-furniture.csv", "text/csv; charset=utf-8", "furniture.csv"},
    {v1::DOCUMENT_FORMAT_LAYOUT_JSON, ".json", "application/json", "room-to-open-again.json"},
    {v1::DOCUMENT_FORMAT_LAYOUT_PB, ".pb", "application/x-protobuf", ""},
    {v1::DOCUMENT_FORMAT_ARTIFACTS_TAR, ".tar", "application/x-tar", ""},
    {v1::DOCUMENT_FORMAT_EVERYTHING_ZIP, ".zip", "application/zip", ""}};

const Format* FormatOf(v1::DocumentFormat format) {
  const auto* const found = std::ranges::find(kFormats, format, &Format::format);
  return found == std::end(kFormats) ? nullptr : found;
}

bool IsCalledByItsBrief(const v1::Document& document) {
  return document.has_brief() && document.title() == TitleOf(document.brief().text());
}

// What a sheet is headed: the document's name. A brief is none: it says what was wished for, not what stands there.
std::string HeadingOf(const v1::Document& document, const v1::Room& room) {
  if (!IsCalledByItsBrief(document)) return document.title();
  std::string kind = room.room_type().empty() ? "room" : room.room_type();
  kind[0] = absl::ascii_toupper(static_cast<unsigned char>(kind[0]));
  return kind;
}

template <typename Request>
void SetOrigin(const v1::Artifact& layout, const v1::Document& document, Request& request) {
  *request.mutable_solved_layout() = Drawable(layout.solved_layout());
  v1::Room& room = *request.mutable_solved_layout()->mutable_graph()->mutable_room();
  room.set_title(HeadingOf(document, room));
  request.set_job_id(layout.id());
  if (!document.has_brief()) return;
  request.set_brief_text(document.brief().text());
  request.set_brief_seed(document.brief().seed());
}

// What a renderer does not know how to draw, or cannot of this room.
bool IsLeftOut(const absl::Status& status) {
  return absl::IsUnimplemented(status) || absl::IsInvalidArgument(status) || absl::IsFailedPrecondition(status);
}

}  // namespace

absl::StatusOr<std::string> Documents::ContentOf(const Record& record, const Layout& layout, v1::DocumentFormat format,
                                                 const v1::RenderOptions& options, CallContext& call) {
  const Format& made = *FormatOf(format);
  const v1::Document document = DocumentOf(record);
  if (made.view != v1::PREVIEW_VIEW_UNSPECIFIED) {
    v1::RenderRequest render;
    SetOrigin(*layout, document, render);
    if (document.has_brief() && made.view == v1::PREVIEW_VIEW_PLAN) {
      render.set_remark(fmt::format("Asked: “{}”", document.brief().text()));
    }
    *render.mutable_options() = options;
    render.mutable_options()->set_view(made.view);
    render.mutable_options()->set_format(made.preview);
    ASSIGN_OR_RETURN(v1::RenderResponse drawn, stages_.Render(std::move(render), call));
    return std::move(*drawn.mutable_preview()->mutable_image());
  }
  switch (format) {
    case v1::DOCUMENT_FORMAT_SCENE_GLB: {
      v1::ExportSceneRequest scene;
      SetOrigin(*layout, document, scene);
      scene.set_format(v1::SCENE_FORMAT_GLB);
      ASSIGN_OR_RETURN(v1::ExportSceneResponse exported, stages_.ExportScene(std::move(scene), call));
      return std::move(*exported.mutable_scene());
    }
    case v1::DOCUMENT_FORMAT_REPORT: {
      ASSIGN_OR_RETURN(const v1::ConstraintCatalog catalog, stages_.Catalog(call));
      return parts_.note_text(layout->solved_layout(), catalog);
    }
    case v1::DOCUMENT_FORMAT_FURNITURE_CSV:
      return FurnitureCsv(layout->solved_layout());
    case v1::DOCUMENT_FORMAT_LAYOUT_PB:
      return cli::ArtifactBytes(*layout);
    case v1::DOCUMENT_FORMAT_LAYOUT_JSON:
      return cli::ToJson(*layout);
    case v1::DOCUMENT_FORMAT_ARTIFACTS_TAR: {
      ASSIGN_OR_RETURN(const std::vector<OutputFile> files, ArtifactFilesOf(layout, kMostArchiveBytes, call));
      return cli::ArchiveOf(files, false);
    }
    default: {
      ASSIGN_OR_RETURN(const std::vector<OutputFile> files, EveryFileOf(record, layout, options.paper(), call));
      return cli::ArchiveOf(files, true);
    }
  }
}

absl::StatusOr<std::vector<OutputFile>> Documents::EveryFileOf(const Record& record, const Layout& layout,
                                                               v1::PaperSize paper, CallContext& call) {
  std::vector<OutputFile> files;
  size_t left = kMostArchiveBytes;
  for (const Format& format : kFormats) {
    if (*format.name == 0) continue;
    v1::RenderOptions options;
    if (format.view == v1::PREVIEW_VIEW_PLAN) options.set_paper(paper);
    if (format.format == v1::DOCUMENT_FORMAT_PLAN_PNG) options.set_dpi(kPrintedDpi);
    absl::StatusOr<std::string> content = ContentOf(record, layout, format.format, options, call);
    if (IsLeftOut(content.status()) || (content.ok() && content->size() > left)) continue;
    if (!content.ok()) return content.status();
    left -= content->size();
    files.push_back({format.name, *std::move(content)});
  }
  ASSIGN_OR_RETURN(std::vector<OutputFile> artifacts, ArtifactFilesOf(layout, left, call));
  for (OutputFile& artifact : artifacts) {
    files.push_back({"artifacts/" + artifact.name, std::move(artifact.content)});
  }
  return files;
}

absl::StatusOr<v1::ExportDocumentResponse> Documents::Export(const v1::ExportDocumentRequest& request,
                                                             CallContext& call) {
  const Format* const format = FormatOf(request.format());
  if (format == nullptr) {
    return InvalidArgument("format: {}; is none that a document has", static_cast<int>(request.format()));
  }
  ASSIGN_OR_RETURN(const Record record, store_->Get(request.document_id()));
  ASSIGN_OR_RETURN(const Layout layout, Shown(record));
  v1::ExportDocumentResponse response;
  const std::string heading = HeadingOf(DocumentOf(record), layout->solved_layout().graph().room());
  response.set_file_name(FileStemOf(heading) + format->ending);
  response.set_media_type(format->media_type);
  ASSIGN_OR_RETURN(*response.mutable_content(), ContentOf(record, layout, request.format(), request.options(), call));
  return response;
}

}  // namespace flair::session
