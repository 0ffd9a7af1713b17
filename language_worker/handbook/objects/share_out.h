// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/program/room_program.h"
#include "language_worker/handbook/reading/brief_facts.h"

namespace flair::language {

// A tertiary to be made: its class and the object that it belongs to (null: the room itself).
struct HostedPiece {
  const ProgramItem* item = nullptr;
  const v1::Object* host = nullptr;
  const v1::Opening* window = nullptr;  // before which it hangs
};

// What the brief says of what carries the pieces of a class; null where it says nothing.
const Place* CarriedAt(const hb::Furniture& furniture, const BriefFacts& facts);

// Finds for tertiaries what carries them, as long as there is room on it. The arguments must outlive it.
class Sharer {
 public:
  // `pieces` are those that are there; it may grow meanwhile.
  Sharer(const RoomProgram& program, const v1::ObjectList& pieces, const v1::Room& room, const Handbook& handbook,
         const BriefFacts& facts);

  // Nothing wider hangs above that piece: there is a window.
  void LimitWall(const std::string& host_id, double width_m) { free_wall_m_[host_id] = width_m; }

  // The pieces of one line of the program; those whose host is missing or full are left out.
  std::vector<HostedPiece> Share(const ProgramItem& item);

 private:
  // What of a top is taken.
  struct Top {
    int count = 0;
    double covered_m2 = 0;
    // Of the piece that takes most.
    double width_m = 0, depth_m = 0;
  };

  bool FindHosts(const ProgramItem& item, std::vector<const v1::Object*>& hosts) const;
  bool FindToldHosts(const hb::Furniture& furniture, std::vector<const v1::Object*>& hosts) const;
  bool TakePlace(const v1::Object& host, const hb::Furniture& piece, bool put_there);
  bool MayHangAnywhere(const ProgramItem& item) const;
  bool TakeWall(const v1::Object& host, const hb::Furniture& piece);

  const RoomProgram& program_;
  const v1::ObjectList& pieces_;
  const Handbook& handbook_;
  const BriefFacts& facts_;
  std::vector<const v1::Opening*> windows_;
  std::map<std::string, double> free_wall_m_;
  std::map<std::string, Top> tops_;
  std::map<std::string, double> hung_m_;
};

}  // namespace flair::language
