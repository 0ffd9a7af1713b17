// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>

#include "flair/model/v1/room_answers.pb.h"
#include "language_worker/handbook/parts/brief_parts.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/model/prompt_text.h"
#include "language_worker/model/steps.h"
#include "llm/answers/prompt_library.h"
#include "room/validation/validate.h"

namespace flair::language {
namespace {

using llm::Fault;
using llm::FaultKind;
using model::v1::ZonesAnswer;

// [Handbook facts] the recorded rooms have three zones on 20 m2; hardly any has more than five.
int UsualMost(double area_m2) {
  if (area_m2 < 6) return 2;
  if (area_m2 < 25) return 3;
  return area_m2 < 45 ? 4 : 6;
}

std::string CountText(double area_m2) {
  const int most = UsualMost(area_m2);
  return most == 2 ? "one or two" : fmt::format("{} to {}", most - 1, most);
}

std::string WantedText(const v1::Brief& brief) {
  const std::vector<std::string> wanted = WantedZones(brief);
  return wanted.empty() ? ""
                        : fmt::format("These are among them, by exactly these names: {}.", fmt::join(wanted, ", "));
}

// What is wrong with an answer that reads well: names given twice, more zones than such a floor has uses for.
std::vector<Fault> CheckZones(const v1::Room& room, const ZonesAnswer& answer) {
  std::vector<Fault> faults;
  std::set<std::string> seen;
  for (int i = 0; i < answer.zones_size(); ++i) {
    const std::string& name = answer.zones(i).name();
    if (!name.empty() && !seen.insert(llm::Bare(name)).second) {
      faults.push_back({fmt::format("zones[{}].name", i), fmt::format("{} is there already", llm::Quoted(name))});
    }
  }
  const double area_m2 = FloorArea(room);
  const int most = UsualMost(area_m2) + 2;
  if (answer.zones_size() > most) {
    faults.push_back({"zones",
                      fmt::format("has {} elements; a floor of {:.0f} m2 has uses for {} at most", answer.zones_size(),
                                  area_m2, most),
                      FaultKind::kDoubtful});
  }
  return faults;
}

v1::ZonePlan ToZonePlan(const ZonesAnswer& answer) {
  v1::ZonePlan plan;
  IdMaker ids;
  for (const model::v1::ZoneAnswer& zone : answer.zones()) {
    v1::Zone& made = *plan.add_zones();
    made.set_id(ids.Make(zone.name(), "zone"));
    made.set_name(PlainName(zone.name()).empty() ? zone.name() : PlainName(zone.name()));
    made.set_purpose(zone.purpose());
  }
  return plan;
}

}  // namespace

absl::StatusOr<v1::ZonePlan> AskZones(const v1::Brief& brief, const v1::Room& room, const ModelTools& tools,
                                      llm::Conversation& conversation) {
  llm::Question question = MakeQuestion(tools, "zones", "zones",
                                        {{"brief", llm::QuoteData(brief.text())},
                                         {"room", ShortRoomText(room)},
                                         {"zone_count", CountText(FloorArea(room))},
                                         {"wanted_zones", WantedText(brief)}},
                                        ZonesAnswer::default_instance());
  question.check = llm::CheckOf<ZonesAnswer>([&](ZonesAnswer& answer) { return CheckZones(room, answer); });
  const auto make = [&](const ZonesAnswer& answer) -> absl::StatusOr<v1::ZonePlan> {
    if (answer.zones().empty()) {
      return absl::DataLossError("step \"zones\": the model's answer has no usable zone, also after a repair");
    }
    v1::ZonePlan plan = ToZonePlan(answer);
    AddWantedZones(brief, plan);
    return plan;
  };
  return AskFor<ZonesAnswer, v1::ZonePlan>(question, conversation, make,
                                           [](const v1::ZonePlan& plan) { return Validate(plan); });
}

}  // namespace flair::language
