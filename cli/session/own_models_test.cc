// SPDX-License-Identifier: GPL-3.0-or-later
// A user's own 3D models, in the studio and for agents.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "CLI/CLI.hpp"
#include "cli/embedded/embedded_services.h"
#include "cli/session/open_documents.h"
#include "orchestrator/testing/temporary_folder.h"
#include "renderer_worker/gltf/gltf.h"

namespace flair::cli {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class OwnModels : public ::testing::Test {
 protected:
  OwnModels() {
    UseOurModels();
    ::setenv("FLAIR_HOME", (folder_.path() + "/home").c_str(), 1);
    std::filesystem::create_directories(Assets());
  }
  ~OwnModels() override { ::unsetenv("FLAIR_HOME"); }

  std::string Assets() const { return folder_.path() + "/assets"; }
  void Write(const std::string& name, const std::string& content) const {
    std::ofstream(Assets() + "/" + name, std::ios::binary) << content;
  }

  static absl::StatusOr<std::unique_ptr<OpenDocuments>> Open(std::vector<std::string> words) {
    CLI::App command;
    const DocumentFlags flags(command);
    std::ranges::reverse(words);
    command.parse(words);
    return OpenDocuments::Open(flags);
  }

  orchestrator::TemporaryFolder folder_;
  runtime::CallContext call_;
};

TEST_F(OwnModels, AreOfferedFirstAndShownInThreeDimensions) {
  renderer::Mesh model;
  renderer::MeshPart& part = model.parts.emplace_back();
  part.material = {.name = "weave", .pattern = renderer::Pattern::kFabric};
  part.positions = {{-0.4F, -0.4F, 0}, {0.4F, -0.4F, 0}, {0.4F, 0.4F, 0.9F}, {-0.4F, 0.4F, 0.9F}};
  part.normals = std::vector<renderer::Vec3>(4, renderer::Normalized({0, -0.9F, 0.8F}));
  part.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  part.indices = {0, 1, 2, 0, 2, 3};
  Write("chair.glb", *renderer::WriteMeshGlb(model, "chair"));
  Write("manifest.json", R"({"assets": [
      {"id": "rattan", "file": "chair.glb", "name": "Rattan armchair", "text": "Woven by hand.",
       "width_m": 0.82, "depth_m": 0.78, "height_m": 0.91},
      {"id": "measured", "file": "chair.glb", "name": "slipper chair"},
      {"id": "huge", "file": "chair.glb", "name": "throne", "width_m": 50, "depth_m": 50, "height_m": 50},
      {"id": "gone", "file": "gone.glb", "name": "stool"}]})");
  const auto open = Open({"--assets", Assets()});
  ASSERT_TRUE(open.ok()) << open.status();
  session::Documents& documents = (*open)->documents();
  const auto all = documents.ListFurniture({}, call_);
  ASSERT_TRUE(all.ok()) << all.status();
  ASSERT_GT(all->offers_size(), 20);
  const v1::FurnitureOffer& armchair = all->offers(0);
  EXPECT_EQ(armchair.group(), "own models");
  EXPECT_EQ(armchair.object().name(), "Rattan armchair");
  EXPECT_EQ(armchair.object().category(), "armchair");
  EXPECT_FLOAT_EQ(static_cast<float>(armchair.object().width_m()), 0.82F);
  EXPECT_THAT(armchair.svg(), HasSubstr("<path"));
  EXPECT_EQ(all->offers(1).object().name(), "slipper chair");
  EXPECT_NEAR(all->offers(1).object().height_m(), 0.9, 1e-5);
  EXPECT_NE(all->offers(2).group(), "own models");
  v1::ListFurnitureRequest words;
  words.set_query("own models");
  EXPECT_EQ(documents.ListFurniture(words, call_)->offers_size(), 2);

  v1::CreateDocumentRequest create;
  create.set_request_id("a study");
  create.mutable_design()->mutable_brief()->set_text("A study that is 4m x 4m.");
  const auto made = documents.Create(create, call_);
  ASSERT_TRUE(made.ok()) << made.status();
  const auto ready = documents.AwaitJob(
      made->document().id(), [](const v1::JobEvent&) {}, call_);
  ASSERT_TRUE(ready.ok()) << ready.status();
  v1::ActRequest add;
  add.set_document_id(ready->id());
  add.set_revision(ready->revision());
  *add.mutable_edit()->add_edits()->mutable_add_object()->mutable_object() = armchair.object();
  const auto added = documents.Act(add, call_);
  ASSERT_TRUE(added.ok()) << added.status();
  v1::ExportDocumentRequest scene;
  scene.set_document_id(ready->id());
  scene.set_format(v1::DOCUMENT_FORMAT_SCENE_GLB);
  const auto drawn = documents.Export(scene, call_);
  ASSERT_TRUE(drawn.ok()) << drawn.status();
  EXPECT_NE(drawn->content().find("\"asset\":\"rattan\""), std::string::npos);
}

TEST_F(OwnModels, BesideTheHandbooksFurnitureWhichHasOtherNames) {
  const auto open = Open({});
  ASSERT_TRUE(open.ok()) << open.status();
  const auto found = [&](const std::string& query) {
    v1::ListFurnitureRequest request;
    request.set_query(query);
    std::vector<std::string> names;
    const auto all = (*open)->documents().ListFurniture(request, call_);
    for (const v1::FurnitureOffer& offer : all->offers()) names.push_back(offer.object().name());
    return names;
  };
  EXPECT_EQ(found("couch").front(), "sofa");
  EXPECT_EQ(found("Closets").front(), "wardrobe");
  EXPECT_THAT(found("picture"), Contains("painting"));
  EXPECT_EQ(found("desk").front(), "desk");
  EXPECT_THAT(found("throwne"), IsEmpty());
}

TEST_F(OwnModels, OfABadFolderAreRefusedAsWhenDrawing) {
  const absl::Status none = Open({"--assets", folder_.path() + "/none"}).status();
  EXPECT_TRUE(absl::IsNotFound(none)) << none;
  EXPECT_THAT(std::string(none.message()), HasSubstr("folder of assets: "));
  Write("manifest.json", "{\"assets\": [");
  const absl::Status bad = Open({"--assets", Assets()}).status();
  EXPECT_TRUE(absl::IsInvalidArgument(bad)) << bad;
  EXPECT_THAT(std::string(bad.message()), HasSubstr("manifest.json"));
}

TEST_F(OwnModels, AreNotForAnOrchestratorElsewhere) {
  const absl::Status status = Open({"--assets", "mine", "--orchestrator", "127.0.0.1:1"}).status();
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr("asset_folder_path: \"mine\""));
}

}  // namespace
}  // namespace flair::cli
