// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>

#include "session/testing/documents_for_test.h"

namespace flair::session {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::Ne;
using ::testing::Not;
using ::testing::Property;

class VariantsTest : public DocumentsTest {};

TEST_F(VariantsTest, WhoTakesFurnishingBackHasTheVariantsOfBefore) {
  const v1::GetDocumentResponse made = Designed();
  const auto found = documents_->FindAlternatives(made.document().id(), made.document().revision(), 2, 0, call_);
  ASSERT_TRUE(found.ok()) << found.status();
  const v1::Document furnished = After(
      [&] {
        const auto furnish = [](v1::ActRequest& act) { act.mutable_furnish()->set_text("A study."); };
        ASSERT_TRUE(Act(found->document(), furnish).ok());
      },
      [](const v1::Document& one) { return one.brief().text() == "A study."; });
  EXPECT_NE(furnished.variants_layout_id(), found->document().variants_layout_id());
  auto last = Act(furnished, [](v1::ActRequest& act) { act.mutable_undo(); });
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_EQ(last->document().variants_layout_id(), found->document().variants_layout_id());
  EXPECT_EQ(last->document().variant_count(), 2);
  last = Act(last->document(), [](v1::ActRequest& act) { act.mutable_redo(); });
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_EQ(last->document().variants_layout_id(), furnished.variants_layout_id());
  EXPECT_EQ(last->document().variant_count(), furnished.variant_count());
  last = Act(last->document(), [](v1::ActRequest& act) { act.mutable_undo(); });
  ASSERT_TRUE(last.ok()) << last.status();
  last = Act(last->document(), [](v1::ActRequest& act) { act.mutable_take_variant()->set_index(1); });
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_EQ(PlacementOf(last->layout(), "double_bed").x_m(), [&] {
    const auto& places = found->layout().runner_ups(1).placements();
    return std::ranges::find(places, "double_bed", &v1::Placement::object_id)->x_m();
  }());
}

TEST_F(VariantsTest, AlternativesAreOtherLayoutsOfWhatIsShown) {
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

  // What they are variants of is taken as they are.
  v1::GetDocumentRequest with_variants;
  with_variants.set_document_id(id);
  with_variants.set_layout_id(found->document().variants_layout_id());
  const auto all = documents_->Get(with_variants);
  ASSERT_TRUE(all.ok()) << all.status();
  EXPECT_EQ(all->layout().SerializeAsString(), found->layout().SerializeAsString());
  const auto first = Act(taken->document(), [](v1::ActRequest& act) { act.mutable_take_variant()->set_index(-1); });
  ASSERT_TRUE(first.ok()) << first.status();
  EXPECT_EQ(PlacementOf(first->layout(), "double_bed").SerializeAsString(),
            PlacementOf(made.layout(), "double_bed").SerializeAsString());
  EXPECT_EQ(first->document().undo_label(), "take variant 1");
  EXPECT_TRUE(absl::IsNotFound(documents_->GetArtifact(std::string(64, '0'), call_).status()));
}

TEST_F(VariantsTest, WhatIsLockedStaysInVariantsFoundBeforeAndAfter) {
  const v1::GetDocumentResponse made = Designed();
  const std::string bed = IdOf(made.layout(), "bed");
  v1::FindVariantsRequest find;
  find.set_document_id(made.document().id());
  find.set_revision(made.document().revision());
  find.set_count(2);
  auto found = documents_->FindVariants(find, call_);
  ASSERT_TRUE(found.ok()) << found.status();
  ASSERT_GT(found->document().variant_count(), 0);
  const auto locked = Act(found->document(), [&](v1::ActRequest& act) {
    act.mutable_edit()->set_without_solving(true);
    act.mutable_edit()->add_edits()->set_pin_object_id(bed);
  });
  ASSERT_TRUE(locked.ok()) << locked.status();
  const v1::Placement stays = PlacementOf(made.layout(), bed);
  const auto expect_locked = [&](const absl::StatusOr<v1::ActResponse>& taken) {
    ASSERT_TRUE(taken.ok()) << taken.status();
    EXPECT_EQ(PlacementOf(taken->layout(), bed).x_m(), stays.x_m());
    EXPECT_EQ(PlacementOf(taken->layout(), bed).y_m(), stays.y_m());
    EXPECT_LT(taken->layout().metrics().deepest_overlap_m(), 1e-6);
    const v1::GetDocumentResponse now = Get(made.document().id());
    ASSERT_EQ(now.layout().graph().pinned_placements_size(), 1);
    EXPECT_EQ(now.layout().graph().pinned_placements(0).object_id(), bed);
  };
  v1::Document last = locked->document();
  int told = 0;
  for (int i = 0; i < found->document().variant_count(); ++i) {
    const auto taken = Act(last, [&](v1::ActRequest& act) { act.mutable_take_variant()->set_index(i); });
    expect_locked(taken);
    told += std::ranges::count(taken->diagnostics(), "lock_kept", &v1::Diagnostic::code);
    EXPECT_THAT(taken->moved_object_ids(), Not(Contains(bed)));
    last = taken->document();
  }
  EXPECT_GT(told, 0);
  find.set_revision(last.revision());
  found = documents_->FindVariants(find, call_);
  ASSERT_TRUE(found.ok()) << found.status();
  last = found->document();
  for (int i = 0; i < found->document().variant_count(); ++i) {
    const auto taken = Act(last, [&](v1::ActRequest& act) { act.mutable_take_variant()->set_index(i); });
    expect_locked(taken);
    EXPECT_EQ(std::ranges::count(taken->diagnostics(), "lock_kept", &v1::Diagnostic::code), 0);
    last = taken->document();
  }
}

TEST_F(VariantsTest, WhatWasAddedAndSaidSinceAVariantWasFoundStays) {
  const v1::GetDocumentResponse made = Designed();
  const std::string id = made.document().id(), wardrobe = IdOf(made.layout(), "wardrobe");
  const std::string desk = IdOf(made.layout(), "desk");
  const auto found = documents_->FindAlternatives(id, made.document().revision(), 1, 0, call_);
  ASSERT_TRUE(found.ok()) << found.status();
  auto last = Act(found->document(),
                  [&](v1::ActRequest& act) { act.mutable_say()->set_text("The wardrobe is against the west wall."); });
  ASSERT_TRUE(last.ok()) << last.status();
  last = Act(last->document(), [&](v1::ActRequest& act) {
    act.mutable_edit()->set_without_solving(true);
    act.mutable_edit()->add_edits()->set_remove_object_id(desk);
    v1::Object& lamp = *act.mutable_edit()->add_edits()->mutable_add_object()->mutable_object();
    lamp.set_name("floor lamp");
    lamp.set_width_m(0.3);
    lamp.set_depth_m(0.3);
    lamp.set_height_m(1.6);
  });
  ASSERT_TRUE(last.ok()) << last.status();
  const v1::GetDocumentResponse before = Get(id);
  const auto taken = Act(before.document(), [](v1::ActRequest& act) { act.mutable_take_variant(); });
  ASSERT_TRUE(taken.ok()) << taken.status();
  const v1::SolvedLayout now = Get(id).layout();
  EXPECT_EQ(now.graph().SerializeAsString(), before.layout().graph().SerializeAsString());
  EXPECT_EQ(PlacementOf(now, "floor_lamp").SerializeAsString(),
            PlacementOf(before.layout(), "floor_lamp").SerializeAsString());
  for (const v1::Placement& at : found->layout().runner_ups(0).placements()) {
    if (at.object_id() == desk) continue;
    EXPECT_EQ(PlacementOf(now, at.object_id()).SerializeAsString(), at.SerializeAsString());
  }
  EXPECT_THAT(now.placements(), Each(Property(&v1::Placement::object_id, Ne(desk))));
}

}  // namespace
}  // namespace flair::session
