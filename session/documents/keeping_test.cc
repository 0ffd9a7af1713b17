// SPDX-License-Identifier: GPL-3.0-or-later
// Documents that are deleted, put back, copied and saved.
#include <gmock/gmock.h>

#include "session/documents/furniture_list.h"
#include "session/testing/documents_for_test.h"

namespace flair::session {
namespace {

using ::testing::HasSubstr;

class KeepingTest : public DocumentsTest {
 protected:
  // Designed, and its bed moved.
  v1::Document Moved() {
    const v1::GetDocumentResponse made = Designed();
    const auto moved = Act(made.document(), [&](v1::ActRequest& act) {
      *act.mutable_move()->add_placements() = Inward(PlacementOf(made.layout(), IdOf(made.layout(), "bed")));
    });
    EXPECT_TRUE(moved.ok()) << moved.status();
    return moved->document();
  }

  absl::Status Delete(const std::string& id) {
    v1::DeleteDocumentRequest request;
    request.set_document_id(id);
    return documents_->Delete(request).status();
  }

  absl::StatusOr<v1::Document> Restore(const std::string& id) {
    v1::RestoreDocumentRequest request;
    request.set_document_id(id);
    const auto restored = documents_->Restore(request);
    if (!restored.ok()) return restored.status();
    return restored->document();
  }
};

TEST_F(KeepingTest, WhatIsDeletedComesBackAsItWasUntilTheServerEnds) {
  const v1::Document document = Moved();
  const std::string before = Export(document.id(), v1::DOCUMENT_FORMAT_LAYOUT_PB);
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(Delete(document.id()).ok());
    const absl::StatusOr<v1::Document> restored = Restore(document.id());
    ASSERT_TRUE(restored.ok()) << restored.status();
    EXPECT_EQ(restored->SerializeAsString(), document.SerializeAsString());
  }
  EXPECT_TRUE(Restore(document.id()).ok()) << "it is there";
  EXPECT_EQ(Export(document.id(), v1::DOCUMENT_FORMAT_LAYOUT_PB), before);
  EXPECT_TRUE(Act(document, [](v1::ActRequest& act) { act.mutable_undo(); }).ok());
  ASSERT_TRUE(Delete(document.id()).ok());
  Reopen();
  EXPECT_TRUE(absl::IsNotFound(Restore(document.id()).status()));
}

TEST_F(KeepingTest, ACopyHasWhatWasSaidAndAHistoryOfItsOwn) {
  const v1::Document document = Moved();
  v1::CreateDocumentRequest request;
  request.set_request_id("copy");
  request.set_document_id(document.id());
  const auto made = documents_->Create(request, call_);
  ASSERT_TRUE(made.ok()) << made.status();
  const v1::Document& copy = made->document();
  EXPECT_NE(copy.id(), document.id());
  EXPECT_EQ(copy.title(), "Copy of A bedroom that is 4m x 5m.");
  EXPECT_EQ(copy.brief().text(), document.brief().text());
  EXPECT_EQ(copy.undo_label(), document.undo_label());
  const std::string bytes = Export(document.id(), v1::DOCUMENT_FORMAT_LAYOUT_PB);
  EXPECT_EQ(Export(copy.id(), v1::DOCUMENT_FORMAT_LAYOUT_PB), bytes);
  EXPECT_EQ(documents_->Create(request, call_)->document().id(), copy.id());

  ASSERT_TRUE(Act(copy, [](v1::ActRequest& act) { act.mutable_undo(); }).ok());
  EXPECT_EQ(Export(document.id(), v1::DOCUMENT_FORMAT_LAYOUT_PB), bytes);
  ASSERT_TRUE(Delete(document.id()).ok());
  EXPECT_NE(Export(copy.id(), v1::DOCUMENT_FORMAT_LAYOUT_PB), bytes);
  request.set_request_id("none");
  EXPECT_TRUE(absl::IsNotFound(documents_->Create(request, call_).status()));
}

TEST_F(KeepingTest, ASheetIsHeadedByTheNameAndNotByWhatWasAsked) {
  const v1::GetDocumentResponse made = Designed();
  const std::string asked = Export(made.document().id(), v1::DOCUMENT_FORMAT_PLAN_SVG);
  EXPECT_THAT(asked, HasSubstr("<title>Bedroom</title>"));
  EXPECT_THAT(asked, HasSubstr("flair:brief: A bedroom that is 4m x 5m."));
  ASSERT_TRUE(Act(made.document(), [](v1::ActRequest& act) { act.set_title("Attic"); }).ok());
  EXPECT_THAT(Export(made.document().id(), v1::DOCUMENT_FORMAT_PLAN_SVG), HasSubstr("<title>Attic</title>"));
}

TEST_F(KeepingTest, FurnitureIsATableWithOneRowForAllThatAreAlike) {
  v1::SolvedLayout layout;
  v1::LayoutGraph& graph = *layout.mutable_graph();
  v1::Zone& zone = *graph.mutable_zone_plan()->add_zones();
  zone.set_id("dining");
  zone.set_name("Dining");
  const auto add = [&](const std::string& id, const std::string& name, v1::ObjectKind kind) -> v1::Object& {
    v1::Object& object = *graph.mutable_object_list()->add_objects();
    object.set_id(id);
    object.set_name(name);
    object.set_kind(kind);
    object.set_zone_id("dining");
    object.set_width_m(0.5);
    object.set_depth_m(0.45);
    object.set_height_m(0.9);
    layout.add_placements()->set_object_id(id);
    return object;
  };
  add("chair_1", "chair", v1::OBJECT_KIND_FLOOR);
  add("chair_2", "chair", v1::OBJECT_KIND_FLOOR);
  add("table", "table, round", v1::OBJECT_KIND_FLOOR);
  add("vase", "vase", v1::OBJECT_KIND_SURFACE).set_host_id("table");
  add("lamp", "=1+1", v1::OBJECT_KIND_CEILING);
  add("spare", "spare", v1::OBJECT_KIND_FLOOR);
  layout.mutable_placements()->RemoveLast();
  EXPECT_EQ(FurnitureCsv(layout),
            "name,count,width_m,depth_m,height_m,where\r\n"
            "chair,2,0.50,0.45,0.90,Dining\r\n"
            "\"table, round\",1,0.50,0.45,0.90,Dining\r\n"
            "vase,1,0.50,0.45,0.90,\"on the table, round\"\r\n"
            "'=1+1,1,0.50,0.45,0.90,\"from the ceiling, Dining\"\r\n");
}

}  // namespace
}  // namespace flair::session
