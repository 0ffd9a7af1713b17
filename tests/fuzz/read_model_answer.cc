// SPDX-License-Identifier: GPL-3.0-or-later
// What a language model, or whoever passes for one, may answer: every type of answer, in metres or another unit; and
// records of answers. answer_promises.h has what must hold.
#include <memory>
#include <string>
#include <vector>

#include "flair/model/v1/calls_answers.pb.h"
#include "flair/model/v1/constraint_answers.pb.h"
#include "flair/model/v1/object_answers.pb.h"
#include "flair/model/v1/room_answers.pb.h"
#include "flair/model/v1/style_answers.pb.h"
#include "llm/answers/read_answer.h"
#include "llm/wrappers/answer_folder.h"
#include "tests/fuzz/answer_promises.h"
#include "tests/fuzz/targets.h"

namespace flair::fuzz {
namespace {

using google::protobuf::Message;

const std::vector<const Message*>& AnswerTypes() {
  using namespace model::v1;  // All answers in one list.
  static const std::vector<const Message*> types = {
      &RoomAnswer::default_instance(),         &ZonesAnswer::default_instance(),
      &FloorObjectsAnswer::default_instance(), &TertiariesAnswer::default_instance(),
      &StyleAnswer::default_instance(),        &IntraAnswer::default_instance(),
      &InterAnswer::default_instance(),        &CleaningAnswer::default_instance(),
      &CallsAnswer::default_instance()};
  return types;
}

// A zone and an object, so that names are looked up too.
const llm::FieldChoices& SomeChoices() {
  static const llm::FieldChoices choices = {
      {"flair.model.v1.FloorObjectAnswer.zone", {{"sleeping", "work"}, {{"bed area", "sleeping"}}}},
      {"flair.model.v1.CallAnswer.function", {{"against_wall", "near"}, {{"ind_next_to_wall", "against_wall"}}}},
      {"flair.model.v1.SentenceCallsAnswer.id", {{"s1", "s2"}, {}}}};
  return choices;
}

void ReadTyped(std::string_view text, const Message& type) {
  const std::unique_ptr<Message> answer(type.New());
  const std::vector<llm::Fault> faults = llm::ReadAnswer(text, SomeChoices(), *answer);
  CheckFaults(faults, *type.GetDescriptor());
  CheckLists(*answer);
  CheckPartialRepair(text, faults, *answer, SomeChoices());
  const std::vector<llm::Fault> left = llm::DropFaulty(faults, *answer);
  Require(left.size() <= faults.size(), "dropping elements finds no faults");
  std::string bytes;
  Require(answer->SerializeToString(&bytes), "what was read can be written");
  if (!left.empty()) return;
  CheckUseful(*answer, SomeChoices());
  CheckReadsTheSame(*answer, SomeChoices());
}

void ReadRecord(std::string_view bytes) {
  const absl::StatusOr<llm::ChatAnswer> answer = llm::ReadRecordJson(std::string(bytes));
  if (!answer.ok()) return;
  const absl::StatusOr<llm::ChatAnswer> again = llm::ReadRecordJson(llm::RecordJson({}, *answer));
  Require(again.ok() && again->text == answer->text, "a record that was read is written the same");
}

}  // namespace

void ReadModelAnswer(std::string_view bytes) {
  if (bytes.empty()) return;
  const size_t byte = static_cast<unsigned char>(bytes.front());
  const size_t choice = byte % (AnswerTypes().size() + 1);
  bytes.remove_prefix(1);
  if (choice < AnswerTypes().size()) {
    ReadTyped(bytes, *AnswerTypes()[choice]);
  } else {
    ReadRecord(bytes);
  }
}

}  // namespace flair::fuzz
