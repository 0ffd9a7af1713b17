// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "language_worker/handbook/program/room_program.h"

namespace flair::language {

// Who sits where: the seats of what one sits at, and so many of both as there are people. The arguments must outlive
// it.
class Seats {
 public:
  Seats(const BriefFacts& facts, const Handbook& handbook, RoomProgram& program)
      : facts_(facts), handbook_(handbook), program_(program) {}

  // Every one of several desks has its chair, every table of a zone of its own the seats that belong to it, or as many
  // as were asked for.
  void SeatAt(const hb::Furniture& furniture, int count, int seats, const std::string& zone);

  // The seats that the brief puts round a piece, and places for all that it says will be there.
  void SeatPeople();

  // Takes stock off the floor; who sat at it goes as well.
  void EraseUnasked(const std::function<bool(const ProgramItem&)>& goes);

  // Without its desk the office chair goes as well, unless another piece brings one or the brief asks for it.
  void RemoveUnaccompanied(const std::string& name);

  // "A round table and four stools": seats of another kind that are asked for right behind the table are its own.
  bool SitsOtherwise(const hb::Furniture& table) const;

 private:
  bool IsWished(const hb::Furniture& furniture) const;
  void SeatAsAsked();
  void CountPeople();
  bool SeatPeopleOnBenches();
  bool SeatPeopleInGroups(const std::string& name);
  bool SeatPeopleAtKin(const std::string& name);
  void SeatPeopleAnywhere();

  const BriefFacts& facts_;
  const Handbook& handbook_;
  RoomProgram& program_;
};

}  // namespace flair::language
