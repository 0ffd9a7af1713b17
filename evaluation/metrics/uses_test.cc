// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>

#include "evaluation/metrics/measures.h"

namespace flair::evaluation {
namespace {

// A desk, its chair and a lamp, of which the lamp is not placed.
class Uses : public ::testing::Test {
 protected:
  Uses() {
    for (const char* id : {"desk", "chair"}) layout_.add_placements()->set_object_id(id);
  }
  v1::Sentence& Say(const std::string& id, const std::string& first, const std::string& second) {
    v1::Sentence& sentence = *layout_.mutable_graph()->mutable_constraint_list()->add_sentences();
    sentence.set_id(id);
    sentence.set_text("The chair is drawn up.");
    sentence.add_subject_ids(first);
    sentence.add_subject_ids(second);
    return sentence;
  }
  v1::EdgeOutcome& Call(const std::string& sentence_id, v1::OutcomeStatus status) {
    layout_.mutable_graph()->add_edges()->set_sentence_id(sentence_id);
    v1::EdgeOutcome& outcome = *layout_.add_edge_outcomes();
    outcome.set_status(status);
    return outcome;
  }
  v1::LayoutMetrics Measure() const {
    v1::LayoutMetrics metrics;
    AddUses(layout_.graph(), layout_.placements(), layout_.edge_outcomes(), metrics);
    return metrics;
  }

  v1::SolvedLayout layout_;
};

TEST_F(Uses, AreSentencesSaidToBeOfUseAndImpliedOnes) {
  Say("s1", "chair", "desk").set_use(true);
  Say("s2", "chair", "desk").set_origin(v1::SENTENCE_ORIGIN_IMPLIED);
  Say("s3", "chair", "desk");
  for (const char* id : {"s1", "s2", "s3"}) Call(id, v1::OUTCOME_STATUS_SATISFIED);
  EXPECT_EQ(Measure().use_count(), 2);
  EXPECT_EQ(Measure().met_use_count(), 2);
  EXPECT_EQ(Measure().findings_size(), 0);
}

TEST_F(Uses, OneThatIsNotMetIsNamedWithItsPartnerAndShortfall) {
  Say("s1", "chair", "desk").set_use(true);
  Call("s1", v1::OUTCOME_STATUS_SATISFIED);
  v1::EdgeOutcome& missed = Call("s1", v1::OUTCOME_STATUS_VIOLATED);
  missed.set_reason("the chair is 0.40 m from the desk, at most 0.10 m");
  missed.set_missed_by(0.3);
  missed.set_unit("m");
  const v1::LayoutMetrics metrics = Measure();
  EXPECT_EQ(metrics.use_count(), 1);
  EXPECT_EQ(metrics.met_use_count(), 0);
  ASSERT_EQ(metrics.findings_size(), 1);
  const v1::Finding& finding = metrics.findings(0);
  EXPECT_EQ(finding.kind(), v1::FINDING_KIND_USE_NOT_MET);
  EXPECT_EQ(finding.object_id(), "chair");
  EXPECT_EQ(finding.partner_id(), "desk");
  EXPECT_EQ(finding.sentence_id(), "s1");
  EXPECT_EQ(finding.amount(), 0.3);
  EXPECT_EQ(finding.message(), missed.reason());
}

TEST_F(Uses, OneThatNoCallWasMadeOfIsNotMet) {
  Say("s1", "chair", "desk").set_use(true);
  ASSERT_EQ(Measure().findings_size(), 1);
  EXPECT_EQ(Measure().findings(0).message(), "no constraint could be made of it");
}

TEST_F(Uses, NobodyUsesWhatIsNotPlaced) {
  Say("s1", "lamp", "desk").set_use(true);
  Call("s1", v1::OUTCOME_STATUS_DROPPED);
  EXPECT_EQ(Measure().use_count(), 0);
  EXPECT_EQ(Measure().findings_size(), 0);
}

}  // namespace
}  // namespace flair::evaluation
