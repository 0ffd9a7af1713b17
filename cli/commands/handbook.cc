// SPDX-License-Identifier: GPL-3.0-or-later
// flair handbook check: furniture, kinds of room and styles of your own, before they are used.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/input/options.h"
#include "language_worker/handbook/loading/load_handbook.h"
#include "language_worker/handbook/sentences/fill.h"
#include "language_worker/handbook/sentences/sentence_writer.h"
#include "optimizer_worker/constraints/registry.h"
#include "translator_worker/grammar/translate.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

namespace hb = language::hb;

// Translates sentences of the handbook by the grammar, each in a small room with what it speaks of.
class SentenceCheck {
 public:
  explicit SentenceCheck(const language::Handbook& handbook) : handbook_(handbook) {
    *request_.mutable_catalog() = optimizer::MakeCatalog();
    for (const char* wall : {"south", "east", "north", "west"}) request_.mutable_room()->add_walls()->set_name(wall);
    request_.mutable_room()->add_openings()->set_kind(v1::OPENING_KIND_DOOR);
    request_.mutable_room()->add_openings()->set_kind(v1::OPENING_KIND_WINDOW);
    request_.mutable_room()->add_sockets();
    v1::Zone& zone = *request_.mutable_zone_plan()->add_zones();
    zone.set_id("main");
    zone.set_name("main");
  }

  // What the grammar does not understand of it; empty when it understands all.
  std::string FaultOf(const language::SentenceTemplate& sentence) {
    request_.clear_object_list();
    request_.clear_constraint_list();
    const bool many = sentence.text.find("{objects}") != std::string::npos;
    const std::string object = sentence.object.empty() ? APiece() : sentence.object;
    v1::Sentence& written = *request_.mutable_constraint_list()->add_sentences();
    for (int i = 0; i < (many ? 2 : 1); ++i) written.add_subject_ids(Add(object, many ? std::to_string(i + 1) : ""));
    const std::string target = sentence.target.empty() ? APiece() : sentence.target;
    if (sentence.text.find("{target") != std::string::npos && target != object) Add(target, "");
    if (sentence.text.find("{first}") != std::string::npos) {
      Add("armchair", "");
      Add("sideboard", "");
    }
    written.set_id("s1");
    written.set_weight(1);
    written.set_scope(v1::SENTENCE_SCOPE_INTER);
    written.set_text(language::Fill(sentence.text, {{"object", object},
                                                    {"objects", language::PluralOf(object, handbook_)},
                                                    {"target", target},
                                                    {"targets", target},
                                                    {"first", "armchair"},
                                                    {"second", "sideboard"},
                                                    {"front_m", "0.9 m"},
                                                    {"sides_m", "0.9 m"},
                                                    {"back_m", "0.9 m"},
                                                    {"side", "left"},
                                                    {"other_side", "right"},
                                                    {"corner", "front right"},
                                                    {"zone", "main"},
                                                    {"wall", "the north wall"},
                                                    {"count", "two"},
                                                    {"seat", object}}));
    const v1::LayoutGraph graph = translator::Translate(request_);
    if (graph.edges_size() > 0 && graph.diagnostics().empty()) return "";
    return fmt::format("\"{}\" is not understood{}{}", written.text(), graph.diagnostics().empty() ? "" : ": ",
                       graph.diagnostics().empty() ? "" : graph.diagnostics(0).message());
  }

 private:
  // A floor piece, where a sentence names none.
  std::string APiece() const {
    return handbook_.FindFurniture("desk") != nullptr ? "desk" : handbook_.contents().furniture(0).name();
  }

  std::string Add(const std::string& name, const std::string& number) {
    v1::Object& object = *request_.mutable_object_list()->add_objects();
    std::string id = number.empty() ? name : name + " " + number;
    std::ranges::replace(id, ' ', '_');
    object.set_id(id);
    object.set_name(name);
    object.set_role(v1::OBJECT_ROLE_SECONDARY);
    object.set_zone_id("main");
    object.set_width_m(1);
    object.set_depth_m(0.5);
    const hb::Furniture* furniture = handbook_.FindFurniture(name);
    const bool floor = furniture == nullptr || furniture->kind() == hb::FURNITURE_KIND_UNSPECIFIED;
    object.set_kind(floor ? v1::OBJECT_KIND_FLOOR : static_cast<v1::ObjectKind>(furniture->kind()));
    object.set_walk_over(furniture != nullptr && furniture->walk_over());
    return id;
  }

  const language::Handbook& handbook_;
  v1::TranslateRequest request_;
};

struct CheckArguments : Options {
  using Options::Options;
  std::vector<std::string>& folders =
      List("DIR DIR...", "Folder with *.textproto files; later folders override earlier ones", true);
};

absl::Status Check(const CheckArguments& arguments) {
  const std::vector<std::string>& folders = arguments.folders;
  ASSIGN_OR_RETURN(language::HandbookFindings findings,
                   language::CheckHandbook(language::DefaultHandbookFolder(), {folders.begin(), folders.end()}));
  std::vector<std::string> faults = std::move(findings.faults);
  if (findings.handbook != nullptr) {
    SentenceCheck check(*findings.handbook);
    for (const language::SentenceTemplate& sentence : findings.sentences) {
      const std::string fault = check.FaultOf(sentence);
      if (!fault.empty()) faults.push_back(fmt::format("{}: {}", sentence.place, fault));
    }
  }
  for (const std::string& fault : faults) fmt::print(stdout, "{}\n", fault);
  for (const std::string& note : findings.notes) fmt::print(stdout, "note: {}\n", note);
  if (!faults.empty()) return InvalidArgument("{}: {}", folders.back(), Counted(faults.size(), "fault"));
  const hb::Handbook& all = findings.handbook->contents();
  fmt::print(stdout, "{}: no faults; {} understood. With ours: {}, {}, {}. Version {}\n", folders.back(),
             Counted(findings.sentences.size(), "sentence"), Counted(all.furniture_size(), "piece"),
             Counted(all.archetypes_size(), "kind of room", "kinds of room"), Counted(all.styles_size(), "style"),
             findings.handbook->version());
  return absl::OkStatus();
}

}  // namespace

void AddHandbook(const Commands& program) {
  program.Group("handbook", "Work on furniture, kinds of room and styles of your own.")
      .Add("check", "Check a folder of handbook data: names, sizes, sentences.", Check,
           "Lists every fault with file, line and field, including sentences that the grammar does not understand. To "
           "use the folder: flair design ... --handbook DIR");
}

}  // namespace flair::cli
