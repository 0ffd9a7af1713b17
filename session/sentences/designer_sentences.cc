// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sentences/designer_sentences.h"

#include <utility>

#include "fmt/format.h"
#include "language_worker/handbook/completion/complete_constraints.h"
#include "language_worker/handbook/parts/furniture_index.h"
#include "language_worker/handbook/sentences/list_constraints.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {

SentencesOf SentencesOfHandbook(std::shared_ptr<const language::Handbook> handbook) {
  return [handbook = std::move(handbook)](const v1::Room& room, const v1::ZonePlan& zones,
                                          const v1::ObjectList& objects) -> absl::StatusOr<v1::ConstraintList> {
    const language::FurnitureIndex index(*handbook);
    v1::Brief brief;
    brief.set_text(fmt::format("A {}.", room.room_type().empty() ? "room" : room.room_type()));
    v1::ObjectList by_class = objects;
    for (v1::Object& object : *by_class.mutable_objects()) {
      const language::hb::Furniture* furniture = index.Find(object.name());
      if (furniture != nullptr) object.set_name(furniture->name());
    }
    ASSIGN_OR_RETURN(const v1::ConstraintList list, language::ListConstraints(brief, room, zones, by_class, *handbook));
    return language::CompleteConstraints({brief, room, zones}, by_class, list, *handbook);
  };
}

}  // namespace flair::session
