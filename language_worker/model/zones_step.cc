// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/zones_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>

#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/model/model_tools.h"
#include "language_worker/model/prompt_text.h"
#include "llm/answers/prompt_library.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

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

// Ids of the zones that the brief's own objects are in, in the order of the objects.
std::vector<std::string> WantedZones(const v1::Brief& brief) {
  std::vector<std::string> wanted;
  for (const v1::Object& object : brief.object_list().objects()) {
    const std::string& zone = object.zone_id();
    if (!zone.empty() && std::find(wanted.begin(), wanted.end(), zone) == wanted.end()) wanted.push_back(zone);
  }
  return wanted;
}

std::string WantedText(const v1::Brief& brief) {
  const std::vector<std::string> wanted = WantedZones(brief);
  return wanted.empty() ? ""
                        : fmt::format("These are among them, by exactly these names: {}.", fmt::join(wanted, ", "));
}

}  // namespace

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

void AddWantedZones(const v1::Brief& brief, v1::ZonePlan& plan) {
  for (const std::string& id : WantedZones(brief)) {
    const bool there =
        std::any_of(plan.zones().begin(), plan.zones().end(), [&](const v1::Zone& zone) { return zone.id() == id; });
    if (there) continue;
    v1::Zone& zone = *plan.add_zones();
    zone.set_id(id);
    zone.set_name(id);
    std::replace(zone.mutable_name()->begin(), zone.mutable_name()->end(), '_', ' ');
    AddDiagnostic(v1::SEVERITY_NOTE, "zone_of_objects",
                  fmt::format("The zone \"{}\" is here because the brief's own objects are in it.", id), plan);
  }
}

absl::StatusOr<v1::ZonePlan> PlanWantedZones(const v1::Brief& brief, const v1::Room& room, const Handbook& handbook) {
  absl::StatusOr<v1::ZonePlan> plan = PlanZones(brief, room, handbook);
  if (plan.ok()) AddWantedZones(brief, *plan);
  return plan;
}

absl::StatusOr<v1::ZonePlan> AskZones(const v1::Brief& brief, const v1::Room& room, const ModelTools& tools,
                                      llm::Conversation& conversation) {
  llm::Question question = MakeQuestion(tools, "zones", "zones",
                                        {{"brief", llm::QuoteData(brief.text())},
                                         {"room", ShortRoomText(room)},
                                         {"zone_count", CountText(FloorArea(room))},
                                         {"wanted_zones", WantedText(brief)}},
                                        ZonesAnswer::default_instance());
  question.repaired_whole = true;
  question.check = llm::CheckOf<ZonesAnswer>([&](ZonesAnswer& answer) { return CheckZones(room, answer); });
  ASSIGN_OR_RETURN(const llm::Reply reply, conversation.Ask(question));
  if (reply.As<ZonesAnswer>().zones().empty()) {
    return absl::DataLossError("step \"zones\": the model's answer has no usable zone, also after a repair");
  }
  v1::ZonePlan plan = ToZonePlan(reply.As<ZonesAnswer>());
  AddWantedZones(brief, plan);
  AddFaults("zones", reply.faults, plan);
  if (absl::Status status = Validate(plan); !status.ok()) return UnusableResult("zones", status);
  return plan;
}

}  // namespace flair::language
