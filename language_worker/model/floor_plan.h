// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "flair/model/v1/object_answers.pb.h"
#include "flair/v1/object_list.pb.h"
#include "language_worker/model/floor_objects_step.h"
#include "language_worker/model/id_maker.h"

namespace flair::language {

// Pieces of floor furniture in all; more are left out.
inline constexpr int kMostFloorObjects = 60;
// Share of the floor that a model is told furniture may cover, and the share above which pieces are left out.
inline constexpr double kUsualCover = 0.45;
inline constexpr double kMostCover = 0.6;

// Turns an answer's floor objects into a list that fits: equal lines joined, too many and too large left out with the
// reason, one primary a zone, counts expanded.
class FloorPlan {
 public:
  // The arguments must outlive it.
  FloorPlan(const ObjectsRequest& request, const ModelTools& tools, const model::v1::FloorObjectsAnswer& answer);

  v1::ObjectList ToList(IdMaker& ids);

 private:
  // A line of the answer.
  struct Line {
    const model::v1::FloorObjectAnswer* answer = nullptr;
    int count = 1;
    bool primary = false;
    // What carries it: floor for all but what the handbook knows better.
    v1::ObjectKind kind = v1::OBJECT_KIND_FLOOR;
    std::vector<std::string> ids = {};
  };

  void JoinEqualLines();
  void MarkPrimaries();
  void LeaveOutTooMany();
  void LeaveOutTooLarge();
  // Takes one piece from the end of the list, primaries and what the brief names last; false when none may go.
  bool LeaveOutOne(bool floor_only, const std::string& reason);
  int Count() const;
  double Covered_m2() const;
  v1::ObjectKind KindOf(const model::v1::FloorObjectAnswer& answer) const;
  void AddObjects(const Line& line, bool primaries, v1::ObjectList& list) const;
  void AddTertiaries(const Line& line, v1::ObjectList& list) const;
  void Describe(const Line& line, const std::string& id, v1::Object& object) const;

  const ObjectsRequest& request_;
  const ModelTools& tools_;
  const model::v1::FloorObjectsAnswer& answer_;
  std::vector<Line> lines_;
  v1::ObjectList list_;  // of which only the omissions and remarks are filled before the end
};

}  // namespace flair::language
