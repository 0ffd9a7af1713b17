// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/designer_sentences.h"

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "language_worker/handbook/completion/complete_constraints.h"
#include "language_worker/handbook/loading/load_handbook.h"
#include "language_worker/handbook/parts/furniture_index.h"
#include "language_worker/handbook/sentences/list_constraints.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {

namespace {

// Read once, by whoever needs it first.
class Reader {
 public:
  explicit Reader(const std::vector<std::string>& overlays) : overlays_(overlays.begin(), overlays.end()) {}

  absl::StatusOr<const language::Handbook*> Get() {
    const std::lock_guard lock(mutex_);
    if (handbook_ == nullptr) {
      ASSIGN_OR_RETURN(handbook_, language::LoadHandbook(language::DefaultHandbookFolder(), overlays_));
    }
    return handbook_.get();
  }

 private:
  const std::vector<std::filesystem::path> overlays_;
  std::mutex mutex_;
  std::unique_ptr<const language::Handbook> handbook_;
};

}  // namespace

SentencesOf SentencesOfHandbook(const std::vector<std::string>& overlays) {
  return [reader = std::make_shared<Reader>(overlays)](
             const v1::Room& room, const v1::ZonePlan& zones,
             const v1::ObjectList& objects) -> absl::StatusOr<v1::ConstraintList> {
    ASSIGN_OR_RETURN(const language::Handbook* const handbook, reader->Get());
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
