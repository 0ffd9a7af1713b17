// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/documents.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <future>
#include <map>
#include <set>

#include "cli/embedded/embedded_services.h"
#include "cli/input/artifact_file.h"
#include "cli/output/artifact_text.h"
#include "cli/output/report_text.h"
#include "orchestrator/testing/temporary_folder.h"
#include "room/conversion/conversion.h"

namespace flair::session {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

// Every service in this process, and the documents of a folder that several Documents may open one after the other.
class DocumentsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    services_ = *cli::EmbeddedServices::Start(folder_.path() + "/store");
    Reopen();
  }

  void Reopen() {
    documents_.reset();
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
    v1::FurnitureOffer& lamp = parts.furniture.emplace_back();
    lamp.mutable_object()->set_name("floor lamp");
    lamp.mutable_object()->set_kind(v1::OBJECT_KIND_FLOOR);
    lamp.mutable_object()->set_role(v1::OBJECT_ROLE_SECONDARY);
    lamp.mutable_object()->set_width_m(0.4);
    lamp.mutable_object()->set_depth_m(0.4);
    lamp.mutable_object()->set_height_m(1.6);
    documents_ = *Documents::Open(folder_.path() + "/documents",
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

  // A designed bedroom, with its layout.
  v1::GetDocumentResponse Designed() {
    v1::CreateDocumentRequest request;
    request.set_request_id("a bedroom");
    request.mutable_design()->mutable_brief()->set_text("A bedroom that is 4m x 5m.");
    request.mutable_design()->mutable_brief()->set_seed(7);
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

  std::string Export(const std::string& id, v1::DocumentFormat format) {
    v1::ExportDocumentRequest request;
    request.set_document_id(id);
    request.set_format(format);
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
v1::Placement Inward(v1::Placement placement) {
  placement.set_x_m(placement.x_m() + (placement.x_m() < 2 ? 0.5 : -0.5));
  return placement;
}

TEST_F(DocumentsTest, ADesignBecomesADocumentWithTheLayoutOfItsJob) {
  const v1::GetDocumentResponse made = Designed();
  EXPECT_EQ(made.document().title(), "A bedroom that is 4m x 5m.");
  EXPECT_EQ(made.document().undo_label(), "");
  const v1::Job job = [&] {
    Stages stages({.orchestrator = services_->orchestrator(),
                   .translator = services_->stages().translator.channel,
                   .optimizer = services_->stages().optimizer.channel,
                   .renderer = services_->stages().renderer.channel});
    return *stages.GetJob(made.document().job_id(), call_);
  }();
  std::vector<std::string> ids;
  for (const v1::ArtifactRef& ref : job.artifacts()) ids.push_back(ref.id());
  EXPECT_THAT(ids, ::testing::Contains(made.document().layout_id()));
}

TEST_F(DocumentsTest, WhatIsMovedStaysJustThereUntilItIsSettled) {
  const v1::GetDocumentResponse made = Designed();
  const std::string desk = IdOf(made.layout(), "wardrobe");
  const v1::Placement to = Inward(PlacementOf(made.layout(), desk));
  const auto moved = Act(made.document(), [&](v1::ActRequest& act) { *act.mutable_move()->add_placements() = to; });
  ASSERT_TRUE(moved.ok()) << moved.status();
  EXPECT_FALSE(moved->layout().has_graph());
  EXPECT_EQ(PlacementOf(moved->layout(), desk).SerializeAsString(), to.SerializeAsString());
  EXPECT_EQ(moved->document().undo_label(), "move the wardrobe");
  for (const v1::Placement& other : made.layout().placements()) {
    if (other.object_id() == desk) continue;
    EXPECT_EQ(PlacementOf(moved->layout(), other.object_id()).SerializeAsString(), other.SerializeAsString());
  }

  const auto settled = Act(moved->document(), [](v1::ActRequest& act) { act.mutable_settle(); });
  ASSERT_TRUE(settled.ok()) << settled.status();
  EXPECT_EQ(PlacementOf(settled->layout(), desk).x_m(), to.x_m());
  EXPECT_LT(settled->layout().metrics().deepest_overlap_m(), 1e-6);
  EXPECT_THAT(Get(made.document().id()).layout().graph().pinned_placements(), IsEmpty());
}

TEST_F(DocumentsTest, OnlyWhatStandsOnAPieceGoesWithIt) {
  const v1::GetDocumentResponse made = Designed();
  std::map<std::string, v1::Object> objects;
  for (const v1::Object& object : made.layout().graph().object_list().objects()) objects[object.id()] = object;
  std::set<std::string> hosts;
  for (const v1::Placement& at : made.layout().placements()) hosts.insert(objects[at.object_id()].host_id());
  hosts.erase("");
  v1::Document document = made.document();
  int carried = 0, left = 0;
  for (const std::string& host : hosts) {
    const v1::Placement to = Inward(PlacementOf(made.layout(), host));
    const auto moved = Act(document, [&](v1::ActRequest& act) { *act.mutable_move()->add_placements() = to; });
    ASSERT_TRUE(moved.ok()) << moved.status();
    document = moved->document();
    for (const v1::Placement& at : made.layout().placements()) {
      const v1::Object& object = objects[at.object_id()];
      if (object.host_id() != host) continue;
      const bool stands = object.kind() == v1::OBJECT_KIND_SURFACE;
      EXPECT_EQ(PlacementOf(moved->layout(), object.id()).x_m() != at.x_m(), stands) << object.id();
      ++(stands ? carried : left);
    }
  }
  EXPECT_GT(carried, 0);
  EXPECT_GT(left, 0);
}

TEST_F(DocumentsTest, UndoToTheStartGivesTheSameBytesAlsoAfterARestart) {
  const v1::GetDocumentResponse made = Designed();
  const std::string before = Export(made.document().id(), v1::DOCUMENT_FORMAT_LAYOUT_PB);
  const std::string bed = IdOf(made.layout(), "bed");
  auto last = Act(made.document(), [&](v1::ActRequest& act) {
    *act.mutable_move()->add_placements() = Inward(PlacementOf(made.layout(), bed));
  });
  ASSERT_TRUE(last.ok()) << last.status();
  last = Act(last->document(), [](v1::ActRequest& act) { act.mutable_settle(); });
  ASSERT_TRUE(last.ok()) << last.status();
  const std::string after = Export(made.document().id(), v1::DOCUMENT_FORMAT_LAYOUT_PB);
  EXPECT_NE(after, before);

  Reopen();
  for (int i = 0; i < 2; ++i) {
    last = Act(last->document(), [](v1::ActRequest& act) { act.mutable_undo(); });
    ASSERT_TRUE(last.ok()) << last.status();
  }
  EXPECT_EQ(Export(made.document().id(), v1::DOCUMENT_FORMAT_LAYOUT_PB), before);
  EXPECT_TRUE(
      absl::IsFailedPrecondition(Act(last->document(), [](v1::ActRequest& act) { act.mutable_undo(); }).status()));
  for (int i = 0; i < 2; ++i) last = Act(last->document(), [](v1::ActRequest& act) { act.mutable_redo(); });
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_EQ(Export(made.document().id(), v1::DOCUMENT_FORMAT_LAYOUT_PB), after);
}

TEST_F(DocumentsTest, WhoHasNotSeenTheLatestRevisionChangesNothing) {
  const v1::GetDocumentResponse made = Designed();
  ASSERT_TRUE(Act(made.document(), [](v1::ActRequest& act) { act.set_title("Mine"); }).ok());
  const auto late = Act(made.document(), [](v1::ActRequest& act) { act.set_title("Yours"); });
  EXPECT_TRUE(absl::IsAborted(late.status()));
  EXPECT_THAT(std::string(late.status().message()), HasSubstr("somebody else has changed it"));
  EXPECT_EQ(Get(made.document().id()).document().title(), "Mine");
}

TEST_F(DocumentsTest, JudgingSaysWhatMovingWouldAndChangesNothing) {
  const v1::GetDocumentResponse made = Designed();
  const std::string bed = IdOf(made.layout(), "bed");
  v1::JudgeRequest judge;
  judge.set_document_id(made.document().id());
  judge.set_revision(made.document().revision());
  *judge.add_placements() = Inward(PlacementOf(made.layout(), bed));
  const auto judged = documents_->Judge(judge, call_);
  ASSERT_TRUE(judged.ok()) << judged.status();
  EXPECT_THAT(judged->edge_outcomes(), Not(IsEmpty()));
  EXPECT_EQ(Get(made.document().id()).document().revision(), made.document().revision());

  const auto moved =
      Act(made.document(), [&](v1::ActRequest& act) { *act.mutable_move()->add_placements() = judge.placements(0); });
  ASSERT_TRUE(moved.ok());
  for (const v1::EdgeOutcome& outcome : judged->edge_outcomes()) {
    for (const v1::EdgeOutcome& then : moved->layout().edge_outcomes()) {
      if (then.edge_id() != outcome.edge_id()) continue;
      EXPECT_EQ(then.status(), outcome.status()) << outcome.edge_id();
    }
  }
}

TEST_F(DocumentsTest, ASentenceIsTranslatedSolvedAndKeptOrRefusedInWords) {
  const v1::GetDocumentResponse made = Designed();
  const auto said = Act(made.document(), [](v1::ActRequest& act) {
    act.mutable_say()->set_text("The wardrobe is against the west wall.");
  });
  ASSERT_TRUE(said.ok()) << said.status();
  const v1::LayoutGraph& graph = said->layout().graph();
  EXPECT_EQ(graph.constraint_list().sentences_size(), made.layout().graph().constraint_list().sentences_size() + 1);
  EXPECT_EQ(said->document().undo_label(), "say \"The wardrobe is against the west wall.\"");
  const auto refused =
      Act(said->document(), [](v1::ActRequest& act) { act.mutable_say()->set_text("Green ideas sleep furiously."); });
  EXPECT_TRUE(absl::IsInvalidArgument(refused.status()));
  EXPECT_THAT(std::string(refused.status().message()), HasSubstr("is not understood"));

  const std::string sentence = graph.constraint_list().sentences().rbegin()->id();
  const auto dropped =
      Act(said->document(), [&](v1::ActRequest& act) { act.mutable_weigh()->set_sentence_id(sentence); });
  ASSERT_TRUE(dropped.ok()) << dropped.status();
  for (const v1::ConstraintEdge& edge : dropped->layout().graph().edges()) EXPECT_NE(edge.sentence_id(), sentence);
}

TEST_F(DocumentsTest, APieceIsAddedWhereItIsDroppedAndGoesAgain) {
  const v1::GetDocumentResponse made = Designed();
  const auto added = Act(made.document(), [](v1::ActRequest& act) {
    act.mutable_edit()->set_without_solving(true);
    v1::Object& lamp = *act.mutable_edit()->add_edits()->mutable_add_object()->mutable_object();
    lamp.set_name("floor lamp");
    lamp.set_width_m(0.4);
    lamp.set_depth_m(0.4);
    lamp.set_height_m(1.6);
    v1::Placement& at = *act.mutable_edit()->add_edits()->mutable_move_object();
    at.set_x_m(2);
    at.set_y_m(2.5);
  });
  ASSERT_TRUE(added.ok()) << added.status();
  EXPECT_THAT(added->moved_object_ids(), ElementsAre("floor_lamp"));
  EXPECT_EQ(PlacementOf(added->layout(), "floor_lamp").y_m(), 2.5);
  EXPECT_EQ(added->document().undo_label(), "add a floor lamp");
  const auto settled = Act(added->document(), [](v1::ActRequest& act) { act.mutable_settle(); });
  ASSERT_TRUE(settled.ok()) << settled.status();
  EXPECT_EQ(PlacementOf(settled->layout(), "floor_lamp").y_m(), 2.5);
  const auto removed = Act(settled->document(), [](v1::ActRequest& act) {
    act.mutable_edit()->add_edits()->set_remove_object_id("floor_lamp");
  });
  ASSERT_TRUE(removed.ok()) << removed.status();
  EXPECT_EQ(IdOf(removed->layout(), "floor lamp"), "");
}

TEST_F(DocumentsTest, APieceIsAddedNearAnotherWithoutKnowingItsId) {
  const v1::GetDocumentResponse made = Designed();
  const std::string bed = IdOf(made.layout(), "bed");
  const auto added = Act(made.document(), [&](v1::ActRequest& act) {
    v1::AddObject& add = *act.mutable_edit()->add_edits()->mutable_add_object();
    add.mutable_object()->set_name("ottoman");
    add.mutable_object()->set_width_m(0.4);
    add.mutable_object()->set_depth_m(0.4);
    add.mutable_object()->set_height_m(0.4);
    v1::ConstraintEdge& near = *add.add_edges();
    near.set_type("near");
    near.set_weight(1);
    for (const auto& [name, id] : {std::pair("object", std::string()), {"target", bed}}) {
      v1::Argument& argument = *near.add_arguments();
      argument.set_name(name);
      argument.mutable_value()->set_text(id);
    }
  });
  ASSERT_TRUE(added.ok()) << added.status();
  EXPECT_EQ(added->document().undo_label(), "add an ottoman");
  const v1::ConstraintEdge& near = *added->layout().graph().edges().rbegin();
  EXPECT_EQ(near.arguments(0).value().text(), "ottoman");
  EXPECT_EQ(added->layout().edge_outcomes().rbegin()->status(), v1::OUTCOME_STATUS_SATISFIED);
}

TEST_F(DocumentsTest, AnOwnRoomIsDrawnChangedAndFurnished) {
  v1::CreateDocumentRequest request;
  request.set_request_id("own");
  v1::Room& room = *request.mutable_room();
  room = Designed().layout().graph().room();
  const auto made = documents_->Create(request, call_);
  ASSERT_TRUE(made.ok()) << made.status();
  EXPECT_EQ(Get(made->document().id()).layout().placements_size(), 0);
  v1::DrawDocumentRequest draw;
  draw.set_document_id(made->document().id());
  const auto drawn = documents_->Draw(draw, call_);
  ASSERT_TRUE(drawn.ok()) << drawn.status();
  EXPECT_NE(drawn->parts().walls_svg(), "");
  EXPECT_EQ(drawn->parts().parts_size(), 0);
  v1::ExplainRequest explain;
  explain.set_document_id(made->document().id());
  EXPECT_TRUE(documents_->Explain(explain, call_).ok());
  room.set_height_m(2.6);
  const auto changed = Act(made->document(), [&](v1::ActRequest& act) { *act.mutable_room() = room; });
  ASSERT_TRUE(changed.ok()) << changed.status();
  EXPECT_EQ(changed->layout().graph().room().height_m(), 2.6);
  const v1::Document furnished = After(
      [&] {
        const auto asked = Act(changed->document(), [](v1::ActRequest& act) {
          act.mutable_furnish()->set_text("A study with a desk and a bookcase.");
        });
        ASSERT_TRUE(asked.ok()) << asked.status();
      },
      [](const v1::Document& one) { return one.job_state() == v1::JOB_STATE_SUCCEEDED; });
  EXPECT_EQ(furnished.undo_label(), "furnish the room");
  EXPECT_NE(IdOf(Get(furnished.id()).layout(), "desk"), "");
  EXPECT_EQ(Get(furnished.id()).layout().graph().room().height_m(), 2.6);
}

TEST_F(DocumentsTest, FilesAreOpenedAndBadOnesRefused) {
  const v1::GetDocumentResponse made = Designed();
  v1::CreateDocumentRequest request;
  request.set_request_id("file");
  request.set_file(Export(made.document().id(), v1::DOCUMENT_FORMAT_LAYOUT_JSON));
  const auto opened = documents_->Create(request, call_);
  ASSERT_TRUE(opened.ok()) << opened.status();
  EXPECT_EQ(opened->document().layout_id(), made.document().layout_id());
  request.set_request_id("bad");
  request.set_file("nothing of ours");
  EXPECT_FALSE(documents_->Create(request, call_).ok());
  const auto listed = documents_->List({});
  std::vector<std::string> ids;
  for (const v1::Document& one : listed->documents()) ids.push_back(one.id());
  EXPECT_THAT(ids, UnorderedElementsAre(made.document().id(), opened->document().id()));
  v1::DeleteDocumentRequest gone;
  gone.set_document_id(opened->document().id());
  EXPECT_TRUE(documents_->Delete(gone).ok());
  EXPECT_TRUE(absl::IsNotFound(documents_->Delete(gone).status()));
}

TEST_F(DocumentsTest, TheChairGoesWithItsDesk) {
  const v1::GetDocumentResponse made = Designed();
  const std::string desk = IdOf(made.layout(), "desk"), chair = IdOf(made.layout(), "chair");
  const v1::Placement from = PlacementOf(made.layout(), desk), seat = PlacementOf(made.layout(), chair);
  const auto moved = Act(made.document(), [&](v1::ActRequest& act) {
    v1::Placement& to = *act.mutable_move()->add_placements();
    to = from;
    to.set_y_m(from.y_m() + 0.4);
  });
  ASSERT_TRUE(moved.ok()) << moved.status();
  EXPECT_NEAR(PlacementOf(moved->layout(), chair).y_m(), seat.y_m() + 0.4, 1e-9);
  EXPECT_NEAR(PlacementOf(moved->layout(), chair).x_m(), seat.x_m(), 1e-9);
}

TEST_F(DocumentsTest, WhatIsSaidOfAPieceThatWasMovedMovesIt) {
  const v1::GetDocumentResponse made = Designed();
  const std::string wardrobe = IdOf(made.layout(), "wardrobe");
  const auto moved = Act(made.document(), [&](v1::ActRequest& act) {
    *act.mutable_move()->add_placements() = Inward(PlacementOf(made.layout(), wardrobe));
  });
  ASSERT_TRUE(moved.ok()) << moved.status();
  const auto said = Act(moved->document(),
                        [](v1::ActRequest& act) { act.mutable_say()->set_text("The wardrobe is against a wall."); });
  ASSERT_TRUE(said.ok()) << said.status();
  const std::string sentence = said->layout().graph().constraint_list().sentences().rbegin()->id();
  for (int i = 0; i < said->layout().edge_outcomes_size(); ++i) {
    if (said->layout().graph().edges(i).sentence_id() != sentence) continue;
    EXPECT_EQ(said->layout().edge_outcomes(i).status(), v1::OUTCOME_STATUS_SATISFIED);
  }
}

TEST_F(DocumentsTest, FurnitureIsFoundByItsWordsWithItsSymbol) {
  v1::ListFurnitureRequest request;
  request.set_query("Lamp");
  const auto found = documents_->ListFurniture(request, call_);
  ASSERT_TRUE(found.ok()) << found.status();
  ASSERT_EQ(found->offers_size(), 1);
  EXPECT_THAT(found->offers(0).svg(), HasSubstr("<path"));
  request.set_query("throne");
  EXPECT_EQ(documents_->ListFurniture(request, call_)->offers_size(), 0);
}

TEST_F(DocumentsTest, AModelIsChosenOnlyWhereTheProgramCan) {
  EXPECT_FALSE(documents_->GetModel().can_choose());
  EXPECT_TRUE(absl::IsUnimplemented(documents_->ChooseModel({}).status()));
}

TEST_F(DocumentsTest, WhoAwaitsAJobSeesItsStepsAndTheLayoutIsAdoptedOnce) {
  v1::CreateDocumentRequest request;
  request.set_request_id("awaited");
  request.mutable_design()->mutable_brief()->set_text("A study that is 3m x 4m.");
  const auto made = documents_->Create(request, call_);
  ASSERT_TRUE(made.ok()) << made.status();
  std::vector<std::string> stages;
  const auto see = [&](const v1::JobEvent& event) {
    if (event.kind() == v1::JOB_EVENT_KIND_STAGE_FINISHED) stages.push_back(event.stage());
  };
  const auto awaited = documents_->AwaitJob(made->document().id(), see, call_);
  ASSERT_TRUE(awaited.ok()) << awaited.status();
  EXPECT_THAT(stages, ::testing::IsSupersetOf({"brief", "solve", "report"}));
  EXPECT_EQ(awaited->job_state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(documents_->AwaitJob(made->document().id(), see, call_)->revision(), awaited->revision());
  Reopen();
  EXPECT_EQ(Get(made->document().id()).document().revision(), awaited->revision());
}

TEST_F(DocumentsTest, WhoGivesUpMayCancelTheJob) {
  v1::CreateDocumentRequest request;
  request.set_request_id("given up");
  request.mutable_design()->mutable_brief()->set_text("A bedroom that is 4m x 5m.");
  request.mutable_design()->mutable_solve_options()->set_max_restart_count(10000);
  const auto made = documents_->Create(request, call_);
  ASSERT_TRUE(made.ok()) << made.status();
  runtime::CallContext waiting;
  const auto awaited = documents_->AwaitJob(
      made->document().id(), [&](const v1::JobEvent&) { waiting.cancellation().Cancel(); }, waiting);
  EXPECT_TRUE(absl::IsCancelled(awaited.status())) << awaited.status();
  ASSERT_TRUE(documents_->CancelJob(made->document().id(), call_).ok());
  const auto ended = documents_->AwaitJob(
      made->document().id(), [](const v1::JobEvent&) {}, call_);
  ASSERT_TRUE(ended.ok()) << ended.status();
  EXPECT_EQ(ended->job_state(), v1::JOB_STATE_CANCELLED);
}

TEST_F(DocumentsTest, AlternativesAreOtherLayoutsOfWhatIsShown) {
  const v1::GetDocumentResponse made = Designed();
  const std::string id = made.document().id();
  const auto found = documents_->FindAlternatives(id, made.document().revision(), 2, 0, call_);
  ASSERT_TRUE(found.ok()) << found.status();
  ASSERT_EQ(found->layout().runner_ups_size(), 2);
  EXPECT_EQ(found->document().variant_count(), 2);
  EXPECT_EQ(found->document().layout_id(), made.document().layout_id());
  const auto taken = Act(found->document(), [](v1::ActRequest& act) { act.mutable_take_variant()->set_index(1); });
  ASSERT_TRUE(taken.ok()) << taken.status();
  EXPECT_EQ(PlacementOf(taken->layout(), "double_bed").SerializeAsString(), [&] {
    v1::SolvedLayout other;
    *other.mutable_placements() = found->layout().runner_ups(1).placements();
    return PlacementOf(other, "double_bed").SerializeAsString();
  }());
  const auto artifact = documents_->GetArtifact(taken->document().layout_id(), call_);
  ASSERT_TRUE(artifact.ok()) << artifact.status();
  EXPECT_EQ(artifact->solved_layout().placements_size(), taken->layout().placements_size());
  EXPECT_TRUE(documents_->GetArtifact(made.document().layout_id(), call_).ok());
  EXPECT_TRUE(absl::IsNotFound(documents_->GetArtifact(std::string(64, '0'), call_).status()));
}

TEST_F(DocumentsTest, WrongPlacesAreRefusedByField) {
  const v1::GetDocumentResponse made = Designed();
  const auto unknown =
      Act(made.document(), [](v1::ActRequest& act) { act.mutable_move()->add_placements()->set_object_id("throne"); });
  EXPECT_THAT(std::string(unknown.status().message()), HasSubstr("move.placements[0].object_id: \"throne\""));
  const auto far = Act(made.document(), [&](v1::ActRequest& act) {
    v1::Placement& at = *act.mutable_move()->add_placements();
    at.set_object_id(IdOf(made.layout(), "bed"));
    at.set_x_m(NAN);
  });
  EXPECT_THAT(std::string(far.status().message()), HasSubstr("move.placements[0].x_m"));
  EXPECT_TRUE(absl::IsInvalidArgument(Act(made.document(), [](v1::ActRequest&) {}).status()));
}

}  // namespace
}  // namespace flair::session
