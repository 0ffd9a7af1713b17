// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "language_worker/handbook/program/room_program.h"
#include "language_worker/handbook/reading/piece_words.h"

namespace flair::language {
namespace {

// Who names that many pieces has said what the room holds.
constexpr int kSaysAll = 4;
// Pictures and lamps that such a room has all the same.
constexpr int kFewest = 3;

// Whether a list of a program has the piece to bring along with another one: chairs at a table, nightstands at a bed.
bool Brings(const ProgramItem& host, const ProgramItem& item, const RoomProgram& program) {
  google::protobuf::RepeatedPtrField<std::string> names;
  for (const hb::ObjectEntry& companion : host.furniture->companions()) names.Add()->assign(companion.furniture());
  return Includes(WithSubstitutes(names, program), item.furniture->name());
}

class StockKeeper {
 public:
  StockKeeper(const BriefFacts& facts, int named, RoomProgram& program)
      : program_(program),
        nothing_else_(facts.nothing_else),
        seats_asked_(std::ranges::any_of(facts.wishes,
                                         [](const Wish& wish) {
                                           const bool island = wish.furniture->category() == "kitchen_counter" &&
                                                               !wish.furniture->companions().empty();
                                           return wish.seats > 0 || island ||
                                                  (wish.count > 1 && IsSeat(*wish.furniture));
                                         })),
        share_(facts.nothing_else ? 0 : std::max(0, kSaysAll - named)) {}

  void Keep() {
    KeepOnFloor();
    int left = std::max(kFewest, program_.max_tertiaries * share_ / kSaysAll);
    std::erase_if(program_.tertiary_items, [&](const ProgramItem& item) {
      if (IsNeeded(item)) return false;
      return (share_ == 0 && !IsLampOrPicture(*item.furniture)) || left-- <= 0;
    });
  }

 private:
  bool IsNeeded(const ProgramItem& item) const { return item.requested || (item.essential > 0 && !nothing_else_); }

  bool IsBrought(const ProgramItem& item) const {
    return (!nothing_else_ || IsSeat(*item.furniture)) &&
           std::ranges::any_of(program_.floor_items,
                               [&](const ProgramItem& host) { return &host != &item && Brings(host, item, program_); });
  }

  // The most important of the stock, and who sits at it.
  void KeepOnFloor() {
    std::set<const hb::Furniture*> brought;
    int alone = 0;
    for (const ProgramItem& item : program_.floor_items) {
      if (IsNeeded(item)) continue;
      if (IsBrought(item)) {
        brought.insert(item.furniture);
      } else {
        ++alone;
      }
    }
    int left = alone * share_ / kSaysAll;
    const std::vector<ProgramItem> all = program_.floor_items;
    std::erase_if(program_.floor_items, [&](const ProgramItem& item) {
      if (IsNeeded(item) || brought.contains(item.furniture) || IsSmallThingBeside(item, all)) return false;
      return IsTableForOthers(item) || IsLargeAmongNamed(item) || left-- <= 0;
    });
    const std::vector<ProgramItem> kept = program_.floor_items;
    std::erase_if(program_.floor_items, [&](const ProgramItem& item) {
      return !IsNeeded(item) && brought.contains(item.furniture) &&
             std::ranges::none_of(kept, [&](const ProgramItem& host) { return Brings(host, item, program_); });
    });
  }

  // The lamp and the little table beside an armchair that was asked for change no room, and it lacks them.
  bool IsSmallThingBeside(const ProgramItem& item, const std::vector<ProgramItem>& all) const {
    constexpr double kSmallM2 = 0.26;
    const hb::Furniture& piece = *item.furniture;
    if (nothing_else_ || piece.width_m().typical() * piece.depth_m().typical() > kSmallM2) return false;
    return std::ranges::any_of(all, [&](const ProgramItem& host) {
      return host.requested && std::ranges::any_of(piece.relations(), [&](const hb::Relation& relation) {
               return relation.use() && Includes(relation.targets(), host.furniture->name());
             });
    });
  }

  // A television that nobody asked for takes the place before the fire from what was, a billiard table that of the
  // poker table. A kitchen has its worktops all the same, and a class its desks.
  bool IsLargeAmongNamed(const ProgramItem& item) const {
    constexpr double kLargeM2 = 0.5;
    constexpr int kSaysMost = 2;
    const hb::Furniture& piece = *item.furniture;
    if (piece.run() != hb::RUN_PART_UNSPECIFIED || piece.name() == program_.archetype->per_person()) return false;
    return share_ <= kSaysAll - kSaysMost && piece.width_m().typical() * piece.depth_m().typical() > kLargeM2;
  }

  // Who asks for an island with stools eats there: no other table.
  bool IsTableForOthers(const ProgramItem& item) const {
    const std::string& category = item.furniture->category();
    if (!seats_asked_ || (category != "table" && category != "round_table")) return false;
    return std::ranges::any_of(program_.floor_items, [&](const ProgramItem& other) {
      return !other.requested && IsSeat(*other.furniture) && Brings(item, other, program_);
    });
  }

  static bool IsLampOrPicture(const hb::Furniture& furniture) {
    return furniture.kind() == hb::FURNITURE_KIND_CEILING || furniture.category() == "table_lamp" ||
           furniture.category() == "painting";
  }

  RoomProgram& program_;
  const bool nothing_else_, seats_asked_;
  const int share_;  // of kSaysAll
};

}  // namespace

int PiecesNamed(const BriefFacts& facts) {
  const auto named = std::ranges::count_if(
      facts.wishes, [](const Wish& wish) { return wish.furniture->kind() != hb::FURNITURE_KIND_SURFACE; });
  // The stock of a kind of room that is only guessed says less.
  return static_cast<int>(facts.archetype_named ? named : 2 * named);
}

bool DoesWhatItsKindDoes(const BriefFacts& facts, const RoomProgram& program) {
  constexpr int kOf = 4;
  std::set<std::string> usual;
  const auto add = [&](const hb::ObjectEntry& entry) {
    usual.insert(entry.furniture());
    usual.insert(entry.or_furniture().begin(), entry.or_furniture().end());
  };
  const auto add_kind = [&](const hb::Archetype& archetype) {
    for (const hb::Band& band : archetype.bands()) std::ranges::for_each(band.objects(), add);
    std::ranges::for_each(archetype.tertiaries(), add);
  };
  add_kind(*program.archetype);
  for (const FurtherKind& also : program.also) add_kind(*also.archetype);
  int named = 0, there = 0;
  for (const Wish& wish : facts.wishes) {
    if (wish.furniture->kind() == hb::FURNITURE_KIND_SURFACE) continue;
    const auto base = facts.base_of_own.find(wish.furniture->name());
    const bool own = base != facts.base_of_own.end() && !base->second.empty();
    ++named;
    there += usual.contains(own ? base->second : wish.furniture->name()) ? 1 : 0;
  }
  return named < kSaysAll || (facts.archetype_named && kOf * there >= named);
}

void BringHosts(const BriefFacts& facts, const Handbook& handbook, RoomProgram& program) {
  constexpr double kLargeM = 0.6;
  for (const Wish& wish : facts.wishes) {
    const hb::Furniture& piece = *wish.furniture;
    if (piece.kind() != hb::FURNITURE_KIND_SURFACE || piece.width_m().typical() < kLargeM) continue;
    const bool carried = std::ranges::any_of(facts.places, [&](const Place& place) {
      return place.furniture == &piece && place.asked->carried() != hb::CARRIED_UNSPECIFIED;
    });
    const std::vector<std::string> hosts = WithSubstitutes(piece.hosts(), program);
    const auto is_there = [&](const std::string& host) { return Lists(program, host); };
    if (carried || std::ranges::any_of(hosts, is_there)) continue;
    for (const std::string& name : hosts) {
      const hb::Furniture* host = handbook.FindFurniture(name);
      if (host == nullptr || Includes(facts.refusals, host) || !IsFloorPiece(*host)) continue;
      program.floor_items.push_back({host, nullptr, 1, HomeOf(*host, program)});
      break;
    }
  }
}

void KeepStock(const BriefFacts& facts, RoomProgram& program) {
  StockKeeper(facts, PiecesNamed(facts), program).Keep();
}

}  // namespace flair::language
