// SPDX-License-Identifier: GPL-3.0-or-later
// Where the handbook may stand in, it answers the steps that the model failed, and no others.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "language_worker/handbook/objects/list_objects.h"
#include "language_worker/handbook/sentences/list_constraints.h"
#include "language_worker/service/testing/model_session.h"
#include "room/validation/validate.h"

namespace flair::language {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// A session whose model fails steps with two useless answers each, and answers all others well.
class FailingSession {
 public:
  explicit FailingSession(const std::string& step) {
    session_.options().set_stand_in_allowed(true);
    Fail(step);
  }

  void Fail(const std::string& step) {
    session_.model().Forget(step);
    session_.model().Answer(step, "I would rather not.");
    session_.model().Answer(step + "/repair", "No.");
  }

  ModelSession* operator->() { return &session_; }

  v1::ListObjectsResponse Objects() {
    EXPECT_TRUE(session_.DescribeRoom().ok());
    EXPECT_TRUE(session_.PlanZones().ok());
    const auto response = session_.ListObjects();
    EXPECT_TRUE(response.ok()) << response.status();
    if (!response.ok()) return {};
    EXPECT_TRUE(Validate(response->object_list(), session_.zones()).ok());
    return *response;
  }

  v1::ListConstraintsResponse Constraints() {
    Objects();
    const auto response = session_.ListConstraints();
    EXPECT_TRUE(response.ok()) << response.status();
    if (!response.ok()) return {};
    EXPECT_TRUE(Validate(response->constraint_list(), session_.objects()).ok());
    return *response;
  }

 private:
  ModelSession session_;
};

template <typename WithDiagnostics>
std::vector<std::string> StandIns(const WithDiagnostics& artifact) {
  std::vector<std::string> remarks;
  for (const v1::Diagnostic& diagnostic : artifact.diagnostics()) {
    if (diagnostic.code() == "stand_in") remarks.push_back(diagnostic.message());
  }
  return remarks;
}

// The serialized objects of a list on that side of the line between floor objects and tertiaries.
std::vector<std::string> Objects(const v1::ObjectList& list, bool tertiaries) {
  std::vector<std::string> objects;
  for (const v1::Object& object : list.objects()) {
    if ((object.role() == v1::OBJECT_ROLE_TERTIARY) == tertiaries) objects.push_back(object.SerializeAsString());
  }
  return objects;
}

std::vector<std::string> Texts(const v1::ConstraintList& list, v1::SentenceScope scope) {
  std::vector<std::string> texts;
  for (const v1::Sentence& sentence : list.sentences()) {
    if (sentence.scope() == scope) texts.push_back(sentence.text());
  }
  return texts;
}

v1::ObjectList GoodObjects() {
  ModelSession session;
  session.DescribeRoom().IgnoreError();
  session.PlanZones().IgnoreError();
  return session.ListObjects()->object_list();
}

v1::ConstraintList GoodConstraints() {
  ModelSession session;
  session.DescribeRoom().IgnoreError();
  session.PlanZones().IgnoreError();
  session.ListObjects().IgnoreError();
  return session.ListConstraints()->constraint_list();
}

TEST(StandIn, FailedTertiariesLeaveTheModelsFloorObjectsAsTheyAre) {
  FailingSession session("objects.tertiary");
  const v1::ListObjectsResponse response = session.Objects();
  const v1::ObjectList& list = response.object_list();
  EXPECT_EQ(Objects(list, /*tertiaries=*/false), Objects(GoodObjects(), /*tertiaries=*/false));
  EXPECT_THAT(Objects(list, /*tertiaries=*/true), Not(IsEmpty()));
  for (const v1::Object& object : list.objects()) EXPECT_EQ(object.placement(), "") << "that of a model's tertiary";
  EXPECT_THAT(StandIns(list), ElementsAre(HasSubstr("step \"objects.tertiary\": ")));
  EXPECT_EQ(response.producer().method(), "fake-1");
  ASSERT_TRUE(session->ListConstraints().ok());
}

TEST(StandIn, TertiariesStandOnWhatTheModelCallsByOtherNames) {
  FailingSession session("objects.tertiary");
  std::string floor = GoodAnswers().at("objects.floor");
  floor.replace(floor.find("\"nightstand\""), 12, "\"small oak nightstand\"");
  session->model().Forget("objects.floor");
  session->model().Answer("objects.floor", floor);
  const v1::ListObjectsResponse response = session.Objects();
  std::set<std::string> hosts;
  for (const v1::Object& object : response.object_list().objects()) hosts.insert(object.host_id());
  EXPECT_THAT(hosts, Contains("small_oak_nightstand_1"));
}

TEST(StandIn, FailedFloorObjectsAreTheHandbooksAndTheModelCompletesThem) {
  FailingSession session("objects.floor");
  const v1::ListObjectsResponse response = session.Objects();
  const v1::ObjectList usual =
      *ListFloorObjects(session->brief(), session->room(), session->zones(), ModelSession::handbook());
  EXPECT_EQ(Objects(response.object_list(), false), Objects(usual, false));
  EXPECT_THAT(Objects(response.object_list(), true), Not(IsEmpty()));
  EXPECT_THAT(response.object_list().ShortDebugString(), HasSubstr("The pendant light hangs in the middle"));
  EXPECT_THAT(StandIns(response.object_list()), ElementsAre(HasSubstr("step \"objects.floor\": ")));
  EXPECT_EQ(response.producer().method(), "fake-1");
}

TEST(StandIn, AListOfWhichBothStepsFailedIsTheHandbooks) {
  FailingSession session("objects.floor");
  session.Fail("objects.tertiary");
  const v1::ListObjectsResponse response = session.Objects();
  v1::ObjectList list = response.object_list();
  EXPECT_THAT(StandIns(list), ElementsAre(AllOf(HasSubstr("objects.floor"), HasSubstr("objects.tertiary"))));
  EXPECT_EQ(response.producer().method(), "handbook");
  EXPECT_EQ(response.model_calls_size(), 4);
  list.clear_diagnostics();
  const v1::ObjectList usual =
      *ListObjects(session->brief(), session->room(), session->zones(), ModelSession::handbook());
  EXPECT_EQ(list.SerializeAsString(), usual.SerializeAsString());
}

TEST(StandIn, AModelThatCannotBeReachedIsNotAskedForWhatFollows) {
  FailingSession session("objects.floor");
  session->model().Forget("objects.floor");
  session->model().Answer("objects.floor", absl::UnavailableError("no route to 127.0.0.1"));
  EXPECT_EQ(session.Objects().producer().method(), "handbook");
  EXPECT_EQ(session->model().requests().back().step, "objects.floor");
}

TEST(StandIn, WithoutLeaveAFailedStepFailsItsStage) {
  for (const char* step : {"objects.floor", "objects.tertiary"}) {
    FailingSession session(step);
    session->options().set_stand_in_allowed(false);
    session->DescribeRoom().IgnoreError();
    session->PlanZones().IgnoreError();
    const absl::Status status = session->ListObjects().status();
    EXPECT_EQ(status.code(), absl::StatusCode::kDataLoss) << step;
    EXPECT_THAT(status.message(), HasSubstr(step));
  }
}

TEST(StandIn, FailedSentencesAboutSingleObjectsLeaveThoseAboutPairs) {
  for (const auto& [step, failed, kept] :
       {std::tuple("constraints.intra", v1::SENTENCE_SCOPE_INTRA, v1::SENTENCE_SCOPE_INTER),
        std::tuple("constraints.inter", v1::SENTENCE_SCOPE_INTER, v1::SENTENCE_SCOPE_INTRA)}) {
    SCOPED_TRACE(step);
    FailingSession session(step);
    const v1::ListConstraintsResponse response = session.Constraints();
    const v1::ConstraintList& list = response.constraint_list();
    const v1::ConstraintList usual = *ListConstraints(session->brief(), session->room(), session->zones(),
                                                      session->objects(), ModelSession::handbook());
    const v1::ConstraintList good = GoodConstraints();
    EXPECT_EQ(Texts(list, kept), Texts(good, kept));
    EXPECT_EQ(Texts(list, failed), Texts(usual, failed));
    EXPECT_NE(Texts(list, failed), Texts(good, failed));
    EXPECT_EQ(Texts(list, v1::SENTENCE_SCOPE_TERTIARY), Texts(good, v1::SENTENCE_SCOPE_TERTIARY));
    EXPECT_THAT(StandIns(list), ElementsAre(HasSubstr(std::string("step \"") + step + "\": ")));
    EXPECT_EQ(response.producer().method(), "fake-1");
  }
}

}  // namespace
}  // namespace flair::language
