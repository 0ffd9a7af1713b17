// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/testing/documents_for_test.h"

namespace flair::session {
namespace {

class CopiesTest : public DocumentsTest {};

TEST_F(CopiesTest, ACopyStandsBesideItsOriginalWithWhatStandsOnIt) {
  const v1::GetDocumentResponse made = Designed();
  v1::Object host, rider;
  for (const v1::Object& object : made.layout().graph().object_list().objects()) {
    if (object.kind() != v1::OBJECT_KIND_SURFACE || object.host_id().empty()) continue;
    for (const v1::Object& other : made.layout().graph().object_list().objects()) {
      if (other.id() != object.host_id() || other.kind() != v1::OBJECT_KIND_FLOOR) continue;
      host = other;
      rider = object;
    }
  }
  ASSERT_NE(rider.id(), "");
  const v1::Placement host_at = PlacementOf(made.layout(), host.id());
  const v1::Placement rider_at = PlacementOf(made.layout(), rider.id());
  const auto copied = Act(made.document(), [&](v1::ActRequest& act) {
    v1::EditLayout& edit = *act.mutable_edit();
    edit.set_without_solving(true);
    const auto add = [&](v1::Object object, v1::Placement at, const std::string& id, const std::string& host_id) {
      object.set_id(id);
      object.set_host_id(host_id);
      *edit.add_edits()->mutable_add_object()->mutable_object() = object;
      at.set_object_id(id);
      at.set_x_m(at.x_m() + 0.25);
      at.set_y_m(at.y_m() - 0.25);
      *edit.add_edits()->mutable_move_object() = at;
    };
    add(host, host_at, "host_copy", host.host_id());
    add(rider, rider_at, "rider_copy", "host_copy");
  });
  ASSERT_TRUE(copied.ok()) << copied.status();
  const v1::Placement host_is = PlacementOf(copied->layout(), "host_copy");
  const v1::Placement rider_is = PlacementOf(copied->layout(), "rider_copy");
  EXPECT_NEAR(rider_is.x_m() - host_is.x_m(), rider_at.x_m() - host_at.x_m(), 1e-9);
  EXPECT_NEAR(rider_is.y_m() - host_is.y_m(), rider_at.y_m() - host_at.y_m(), 1e-9);
  EXPECT_EQ(rider_is.z_m(), rider_at.z_m());
  EXPECT_LT(copied->layout().metrics().deepest_overlap_m(), 1e-6);
}

}  // namespace
}  // namespace flair::session
