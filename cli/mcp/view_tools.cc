// SPDX-License-Identifier: GPL-3.0-or-later
// Tools that look at rooms and write them to files, and rooms as resources.
#include <google/protobuf/util/json_util.h>
#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "absl/strings/escaping.h"
#include "absl/strings/str_split.h"
#include "cli/explain/layout_note.h"
#include "cli/input/artifact_file.h"
#include "cli/mcp/document_tools.h"
#include "cli/mcp/layout_json.h"
#include "cli/output/artifact_text.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli::mcp {
namespace {

// In base64 it stays below a megabyte.
constexpr size_t kMostPictureBytes = 740'000;
constexpr int kLeastPicture_px = 256;
constexpr char kDocumentUri[] = "flair://document/", kArtifactUri[] = "flair://artifact/";

// Files of a document that are resources.
struct DocumentFile {
  const char* name;
  v1::DocumentFormat format;
  const char* media_type;
  const char* about;
  bool is_text = true;
};
constexpr DocumentFile kFiles[] = {
    {"layout.json", v1::DOCUMENT_FORMAT_LAYOUT_JSON, "application/json", "The artifact of the layout"},
    {"report.md", v1::DOCUMENT_FORMAT_REPORT, "text/markdown", "Why everything stands where it stands"},
    {"plan.svg", v1::DOCUMENT_FORMAT_PLAN_SVG, "image/svg+xml", "The plan, to scale"},
    {"plan.png", v1::DOCUMENT_FORMAT_PLAN_PNG, "image/png", "The plan as pixels", false},
    {"scene.glb", v1::DOCUMENT_FORMAT_SCENE_GLB, "model/gltf-binary", "The room in three dimensions", false}};

// "plan_pdf" is DOCUMENT_FORMAT_PLAN_PDF.
v1::DocumentFormat FormatOf(const std::string& word) {
  v1::DocumentFormat format = v1::DOCUMENT_FORMAT_UNSPECIFIED;
  if (word == "report_md") return v1::DOCUMENT_FORMAT_REPORT;
  std::string name = "DOCUMENT_FORMAT_" + word;
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  v1::DocumentFormat_Parse(name, &format);
  return format;
}

// Whether a file is one that Flair has written: artifacts can be read, and pictures and scenes name their maker.
bool IsOurs(const std::string& name, const std::string& content) {
  for (const char* magic : {"\x89PNG", "<?xml", "%PDF"}) {
    if (content.starts_with(magic)) return content.find("flair:job_id") != std::string::npos;
  }
  if (content.starts_with("glTF")) return content.find("\"generator\":\"Flair ") != std::string::npos;
  if (content.starts_with("layout.pb")) return true;  // an archive
  const absl::StatusOr<ArtifactFile> file = ParseArtifactFile(name, content);
  return file.ok() && file->whole.ok();
}

}  // namespace

DocumentTools::Result DocumentTools::List(const Json& arguments) {
  v1::ListDocumentsRequest request;
  request.set_page_size(arguments.value("limit", 20));
  ASSIGN_OR_RETURN(const v1::ListDocumentsResponse listed, documents_.List(request));
  ToolResult result;
  result.structured["documents"] = Json::array();
  for (const v1::Document& document : listed.documents()) {
    const bool running = document.job_state() == v1::JOB_STATE_QUEUED || document.job_state() == v1::JOB_STATE_RUNNING;
    const bool ready = !document.layout_id().empty();
    Json json = {{"document_id", document.id()},
                 {"title", document.title()},
                 {"revision", document.revision()},
                 {"state", running ? "designing"
                           : ready ? "ready"
                                   : "failed"},
                 {"updated", google::protobuf::util::TimeUtil::ToString(document.update_time())}};
    if (!document.job_error().empty()) json["error"] = document.job_error();
    result.structured["documents"].push_back(std::move(json));
  }
  return result;
}

DocumentTools::Result DocumentTools::Explain(const Json& arguments, ToolCall& call) {
  v1::ExplainRequest request;
  request.set_document_id(arguments.at("document_id").get<std::string>());
  ASSIGN_OR_RETURN(const v1::ExplainResponse explained, documents_.Explain(request, call.context()));
  std::string text;
  if (!google::protobuf::util::MessageToJsonString(explained.note(), &text).ok()) {
    return absl::InternalError("the note cannot be written as JSON");
  }
  Note note = Note::parse(text);
  const bool whole = !arguments.contains("object");
  if (!whole) {
    ASSIGN_OR_RETURN(note, FindObject(note, arguments.at("object").get<std::string>()));
  }
  ToolResult result;
  result.structured = {{"document_id", request.document_id()},
                       {"revision", explained.revision()},
                       {"note", Json::parse(note.dump())},
                       {"not_as_asked", Json::array()}};
  for (const std::string& line : explained.not_as_asked()) result.structured["not_as_asked"].push_back(line);
  result.content.push_back(
      {{"type", "text"}, {"text", whole ? NoteText(note, {.all = false}) : ObjectText(note, {.all = true})}});
  return result;
}

DocumentTools::Result DocumentTools::Render(const Json& arguments, ToolCall& call) {
  const std::string view = arguments.value("view", "plan");
  v1::ExportDocumentRequest request;
  request.set_document_id(arguments.at("document_id").get<std::string>());
  request.set_format(FormatOf(view + "_png"));
  int size_px = arguments.value("size_px", view == "plan" ? 1400 : 800);
  v1::ExportDocumentResponse drawn;
  while (true) {
    request.mutable_options()->set_size_px(size_px);
    ASSIGN_OR_RETURN(drawn, documents_.Export(request, call.context()));
    const double share = static_cast<double>(kMostPictureBytes) / static_cast<double>(drawn.content().size());
    if (share >= 1) break;
    if (size_px == kLeastPicture_px) return absl::ResourceExhaustedError("the picture is too large at any size");
    size_px = std::max(kLeastPicture_px, static_cast<int>(size_px * std::sqrt(share) * 0.9));
  }
  ToolResult result;
  result.content.push_back(
      {{"type", "image"}, {"data", absl::Base64Escape(drawn.content())}, {"mimeType", drawn.media_type()}});
  result.structured = {{"document_id", request.document_id()},
                       {"view", view},
                       {"media_type", drawn.media_type()},
                       {"size_px", size_px},
                       {"byte_count", drawn.content().size()}};
  return result;
}

DocumentTools::Result DocumentTools::Export(const Json& arguments, ToolCall& call) {
  v1::ExportDocumentRequest request;
  request.set_document_id(arguments.at("document_id").get<std::string>());
  request.set_format(FormatOf(arguments.at("format").get<std::string>()));
  ASSIGN_OR_RETURN(const v1::ExportDocumentResponse made, documents_.Export(request, call.context()));
  ASSIGN_OR_RETURN(const std::string path, root_.Write(arguments.value("path", made.file_name()), made.content(),
                                                       {.any = arguments.value("overwrite", false), .ours = IsOurs}));
  ToolResult result;
  result.structured = {{"path", path}, {"media_type", made.media_type()}, {"byte_count", made.content().size()}};
  return result;
}

DocumentTools::Result DocumentTools::Share(const Json& arguments, ToolCall& call) {
  v1::ShareDocumentRequest request;
  request.set_document_id(arguments.at("document_id").get<std::string>());
  ASSIGN_OR_RETURN(const v1::ShareDocumentResponse shared, documents_.Share(request, call.context()));
  ToolResult result;
  result.structured = {{"job_id", shared.job_id()}};
  return result;
}

DocumentTools::Result DocumentTools::FindFurniture(const Json& arguments, ToolCall& call) {
  v1::ListFurnitureRequest request;
  request.set_query(arguments.value("words", ""));
  ASSIGN_OR_RETURN(const v1::ListFurnitureResponse found, documents_.ListFurniture(request, call.context()));
  ToolResult result;
  result.structured["furniture"] = Json::array();
  for (const v1::FurnitureOffer& offer : found.offers()) {
    if (result.structured["furniture"].size() >= arguments.value("limit", size_t{20})) break;
    Json piece = PlaceJson({}, offer.object(), nullptr);
    piece.erase("id");
    piece.erase("placed");
    piece["group"] = offer.group();
    result.structured["furniture"].push_back(std::move(piece));
  }
  return result;
}

Resources DocumentTools::MakeResources() {
  Resources resources;
  resources.list = [this] { return ListResources(); };
  resources.read = [this](const std::string& uri, runtime::CallContext& call) { return ReadResource(uri, call); };
  for (const DocumentFile& file : kFiles) {
    resources.templates.push_back({{"uriTemplate", fmt::format("{}{{document_id}}/{}", kDocumentUri, file.name)},
                                   {"name", file.name},
                                   {"description", file.about},
                                   {"mimeType", file.media_type}});
  }
  resources.templates.push_back({{"uriTemplate", fmt::format("{}{{artifact_id}}", kArtifactUri)},
                                 {"name", "artifact"},
                                 {"description", "Any artifact of a document or a job, as JSON"},
                                 {"mimeType", "application/json"}});
  return resources;
}

absl::StatusOr<Json> DocumentTools::ListResources() {
  ASSIGN_OR_RETURN(const v1::ListDocumentsResponse listed, documents_.List({}));
  Json resources = Json::array();
  for (const v1::Document& document : listed.documents()) {
    if (document.layout_id().empty()) continue;
    for (const DocumentFile& file : kFiles) {
      resources.push_back({{"uri", fmt::format("{}{}/{}", kDocumentUri, document.id(), file.name)},
                           {"name", file.name},
                           {"title", fmt::format("{}: {}", document.title(), file.name)},
                           {"description", file.about},
                           {"mimeType", file.media_type}});
    }
  }
  return resources;
}

absl::StatusOr<Json> DocumentTools::ReadResource(const std::string& uri, runtime::CallContext& call) {
  if (uri.starts_with(kArtifactUri)) {
    ASSIGN_OR_RETURN(const v1::Artifact artifact, documents_.GetArtifact(uri.substr(sizeof kArtifactUri - 1), call));
    return Json{{"uri", uri}, {"mimeType", "application/json"}, {"text", ToJson(artifact)}};
  }
  const std::vector<std::string> parts =
      absl::StrSplit(uri.starts_with(kDocumentUri) ? uri.substr(sizeof kDocumentUri - 1) : "", '/');
  const auto* const file = std::ranges::find_if(
      kFiles, [&](const DocumentFile& each) { return parts.size() == 2 && parts[1] == each.name; });
  if (file == std::end(kFiles)) return NotFound("uri: no resource \"{}\"", uri.substr(0, 200));
  v1::ExportDocumentRequest request;
  request.set_document_id(parts[0]);
  request.set_format(file->format);
  ASSIGN_OR_RETURN(v1::ExportDocumentResponse made, documents_.Export(request, call));
  Json read = {{"uri", uri}, {"mimeType", file->media_type}};
  if (file->is_text) {
    read["text"] = std::move(*made.mutable_content());
  } else {
    read["blob"] = absl::Base64Escape(made.content());
  }
  return read;
}

}  // namespace flair::cli::mcp
