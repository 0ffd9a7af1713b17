// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <future>
#include <memory>
#include <string>

#include "cli/embedded/embedded_services.h"
#include "cli/input/artifact_file.h"
#include "cli/output/report_text.h"
#include "language_worker/handbook/loading/load_handbook.h"
#include "orchestrator/testing/temporary_folder.h"
#include "session/documents/documents.h"
#include "session/sentences/designer_sentences.h"

namespace flair::session {

// Every service in this process, and the documents of a folder that several Documents may open one after the other.
class DocumentsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    services_ = *cli::EmbeddedServices::Start(folder_.path() + "/store");
    Reopen();
  }

  void Reopen() {
    documents_.reset();
    documents_ = OpenIn("documents");
  }

  // Those of another machine when the folder is another one.
  std::unique_ptr<Documents> OpenIn(const std::string& folder) {
    const orchestrator::StageChannels& stages = services_->stages();
    DocumentParts parts;
    parts.read_file = [](const std::string& bytes) -> absl::StatusOr<v1::Artifact> {
      absl::StatusOr<cli::ArtifactFile> file = cli::ParseArtifactFile("file", bytes);
      if (!file.ok()) return file.status();
      if (!file->good.ok()) return file->good;
      return file->artifact;
    };
    parts.note_json = [](const auto&, const auto&) { return std::string("{}"); };
    parts.note_text = parts.note_json;
    parts.not_as_asked = cli::NotAsAsked;
    static const std::shared_ptr<const language::Handbook> handbook =
        *language::LoadHandbook(language::DefaultHandbookFolder(), {});
    parts.sentences_of = SentencesOfHandbook(handbook);
    const auto offer = [&](const char* name, double width_m, double depth_m, double height_m) -> v1::Object& {
      v1::Object& object = *parts.furniture.emplace_back().mutable_object();
      object.set_name(name);
      object.set_kind(v1::OBJECT_KIND_FLOOR);
      object.set_role(v1::OBJECT_ROLE_SECONDARY);
      object.set_width_m(width_m);
      object.set_depth_m(depth_m);
      object.set_height_m(height_m);
      return object;
    };
    offer("floor lamp", 0.4, 0.4, 1.6);
    offer("desk", 1.2, 0.6, 0.75).set_sat_at(true);
    offer("desk chair", 0.5, 0.5, 0.9).set_seat(true);
    offer("bookshelf", 0.8, 0.3, 1.9);
    offer("floor plant", 0.4, 0.4, 1.2);
    v1::Object& vase = offer("vase", 0.15, 0.15, 0.3);
    vase.set_kind(v1::OBJECT_KIND_SURFACE);
    vase.set_role(v1::OBJECT_ROLE_TERTIARY);
    v1::Object& picture = offer("picture", 0.6, 0.04, 0.5);
    picture.set_kind(v1::OBJECT_KIND_WALL);
    picture.set_role(v1::OBJECT_ROLE_TERTIARY);
    picture.set_elevation_m(1.4);
    parts.furniture_words = {{"bookcase", {3}}, {"chair", {2}}};
    return *Documents::Open(folder_.path() + "/" + folder,
                            {.orchestrator = services_->orchestrator(),
                             .translator = stages.translator.channel,
                             .optimizer = stages.optimizer.channel,
                             .renderer = stages.renderer.channel},
                            std::move(parts));
  }

  // The first event about a document that `enough` says yes to, among those that `act` and its job bring.
  v1::Document After(const std::function<void()>& act, const std::function<bool(const v1::Document&)>& enough) {
    std::promise<v1::Document> told;
    bool done = false;
    const int key = documents_->events().Subscribe([&](const v1::WatchDocumentsResponse& event) {
      if (done || !event.has_document() || !enough(event.document())) return;
      done = true;
      told.set_value(event.document());
    });
    act();
    v1::Document document = told.get_future().get();
    documents_->events().Unsubscribe(key);
    return document;
  }

  // A designed room, with its layout.
  v1::GetDocumentResponse Designed(const std::string& brief = "A bedroom that is 4m x 5m.", int seed = 7) {
    v1::CreateDocumentRequest request;
    request.set_request_id(brief + std::to_string(seed));
    request.mutable_design()->mutable_brief()->set_text(brief);
    request.mutable_design()->mutable_brief()->set_seed(seed);
    const v1::Document document =
        After([&] { ASSERT_TRUE(documents_->Create(request, call_).ok()); },
              [](const v1::Document& one) { return one.job_state() == v1::JOB_STATE_SUCCEEDED; });
    return Get(document.id());
  }

  v1::GetDocumentResponse Get(const std::string& id) {
    v1::GetDocumentRequest request;
    request.set_document_id(id);
    return *documents_->Get(request);
  }

  absl::StatusOr<v1::ActResponse> Act(const v1::Document& document, const std::function<void(v1::ActRequest&)>& set) {
    v1::ActRequest request;
    request.set_document_id(document.id());
    request.set_revision(document.revision());
    set(request);
    return documents_->Act(request, call_);
  }

  std::string Export(const std::string& id, v1::DocumentFormat format,
                     v1::PaperSize paper = v1::PAPER_SIZE_UNSPECIFIED) {
    v1::ExportDocumentRequest request;
    request.set_document_id(id);
    request.set_format(format);
    request.mutable_options()->set_paper(paper);
    return documents_->Export(request, call_)->content();
  }

  static v1::Placement PlacementOf(const v1::SolvedLayout& layout, const std::string& id) {
    for (const v1::Placement& placement : layout.placements()) {
      if (placement.object_id() == id) return placement;
    }
    ADD_FAILURE() << id << " is not placed";
    return {};
  }

  // The id of the first object of a name.
  static std::string IdOf(const v1::SolvedLayout& layout, const std::string& name) {
    for (const v1::Object& object : layout.graph().object_list().objects()) {
      if (object.name().find(name) != std::string::npos) return object.id();
    }
    return "";
  }

  orchestrator::TemporaryFolder folder_;
  std::unique_ptr<cli::EmbeddedServices> services_;
  std::unique_ptr<Documents> documents_;
  runtime::CallContext call_;
};

// Half a metre towards the middle of a room of 4 m x 5 m.
inline v1::Placement Inward(v1::Placement placement) {
  placement.set_x_m(placement.x_m() + (placement.x_m() < 2 ? 0.5 : -0.5));
  return placement;
}

}  // namespace flair::session
