// SPDX-License-Identifier: GPL-3.0-or-later
// What a language model, or whoever passes for one, may answer: every type of answer, in metres or another unit; and
// records of answers. What must hold comes first.
#include <google/protobuf/util/json_util.h>
#include <google/protobuf/util/message_differencer.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "flair/model/v1/calls_answers.pb.h"
#include "flair/model/v1/constraint_answers.pb.h"
#include "flair/model/v1/object_answers.pb.h"
#include "flair/model/v1/room_answers.pb.h"
#include "flair/model/v1/style_answers.pb.h"
#include "llm/answers/read_answer.h"
#include "llm/openai/reply_reader.h"
#include "llm/wrappers/llm_wrappers.h"
#include "tests/fuzz/targets.h"

namespace flair::fuzz {
namespace {

namespace pb = google::protobuf;

constexpr int kMostItems = 1000;
constexpr int kMostCharacters = 400;
constexpr size_t kLongestFault = 3000;

// Without control characters, and UTF-8.
bool IsPlainLine(std::string_view text) {
  return std::ranges::none_of(text, [](unsigned char c) { return c < 0x20 || c == 0x7F; }) && llm::ToUtf8(text) == text;
}

int Characters(std::string_view text) {
  return static_cast<int>(std::ranges::count_if(text, [](unsigned char c) { return (c & 0xC0) != 0x80; }));
}

// The field that a path leads to, such as "objects[3].width_m"; null for none.
const pb::FieldDescriptor* FieldAt(std::string_view path, const pb::Descriptor& type) {
  const pb::Descriptor* message = &type;
  const pb::FieldDescriptor* field = nullptr;
  while (!path.empty()) {
    const std::string_view step = path.substr(0, path.find('.'));
    path.remove_prefix(std::min(step.size() + 1, path.size()));
    if (message == nullptr) return nullptr;
    field = message->FindFieldByName(std::string(step.substr(0, step.find('['))));
    if (field == nullptr || (step.find('[') != std::string_view::npos && !field->is_repeated())) return nullptr;
    message = field->message_type();
  }
  return field;
}

bool IsPath(std::string_view path, const pb::Descriptor& type) {
  return path.empty() || FieldAt(path, type) != nullptr;
}

// Calls `see` with the message and all messages in it.
void ForAll(const pb::Message& message, const std::function<void(const pb::Message&)>& see) {
  see(message);
  const pb::Reflection& reflection = *message.GetReflection();
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const pb::FieldDescriptor* const field = message.GetDescriptor()->field(i);
    if (field->cpp_type() != pb::FieldDescriptor::CPPTYPE_MESSAGE || !field->is_repeated()) continue;
    for (int item = 0; item < reflection.FieldSize(message, field); ++item) {
      ForAll(reflection.GetRepeatedMessage(message, field, item), see);
    }
  }
}

void CheckNumber(double number, const pb::FieldDescriptor& field) {
  const llm::NumberRange range = llm::RangeOf(field);
  Require(std::isfinite(number) && number >= range.least && number <= range.most,
          field.full_name() + " is finite and in its range");
}

void CheckText(const std::string& text, const pb::FieldDescriptor& field, const llm::FieldChoices& choices) {
  const model::v1::FieldFacts& facts = llm::FactsOf(field);
  Require(IsPlainLine(text), field.full_name() + " is one line of text");
  if (!facts.notation()) Require(!text.empty(), field.full_name() + " says something");
  if (const auto texts = llm::TextsOf(field, choices)) {
    Require(std::ranges::count(texts->names, text) > 0, field.full_name() + " is a choice");
  } else {
    const int most = facts.max_length() > 0 ? facts.max_length() : kMostCharacters;
    Require(Characters(text) <= most, field.full_name() + " is no longer than it may be");
  }
}

void CheckField(const pb::Message& message, const pb::FieldDescriptor& field, const llm::FieldChoices& choices) {
  const pb::Reflection& reflection = *message.GetReflection();
  if (!field.is_repeated() && field.has_presence() && !reflection.HasField(message, &field)) return;
  switch (field.cpp_type()) {
    case pb::FieldDescriptor::CPPTYPE_DOUBLE:
      return CheckNumber(reflection.GetDouble(message, &field), field);
    case pb::FieldDescriptor::CPPTYPE_INT32:
      return CheckNumber(reflection.GetInt32(message, &field), field);
    case pb::FieldDescriptor::CPPTYPE_STRING:
      if (!field.is_repeated()) return CheckText(reflection.GetString(message, &field), field, choices);
      for (int i = 0; i < reflection.FieldSize(message, &field); ++i) {
        CheckText(reflection.GetRepeatedString(message, &field, i), field, choices);
      }
      return;
    default:
      return;
  }
}

// Of a list that has lost the last of its elements.
bool IsEmptyList(const llm::Fault& fault, const pb::Descriptor& type) {
  const pb::FieldDescriptor* const field = FieldAt(fault.path, type);
  return field != nullptr && llm::FactsOf(*field).min_items() > 0 && fault.text.starts_with("has 0 elements");
}

// Every fault says where it is, in fields that there are, and what is wrong, in text that may go into a log or a
// prompt.
void CheckFaults(std::span<const llm::Fault> faults, const pb::Descriptor& type) {
  for (const llm::Fault& fault : faults) {
    Require(!fault.text.empty() && fault.text.size() < kLongestFault, "a fault says shortly what is wrong");
    Require(IsPlainLine(fault.text), "a fault is one line of text: " + fault.text);
    Require(IsPath(fault.path, type), "a fault names a field: " + fault.path);
  }
}

// No list is longer than it may be.
void CheckLists(const pb::Message& answer) {
  ForAll(answer, [](const pb::Message& message) {
    for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
      const pb::FieldDescriptor* const field = message.GetDescriptor()->field(i);
      if (!field->is_repeated()) continue;
      const int most = llm::FactsOf(*field).max_items() > 0 ? llm::FactsOf(*field).max_items() : kMostItems;
      Require(message.GetReflection()->FieldSize(message, field) <= most, field->full_name() + " is short enough");
    }
  });
}

// An answer that nothing wrong is left in: numbers finite and in their range, texts on one line, no longer than they
// may be, and among the choices where there are some.
void CheckUseful(const pb::Message& answer, const llm::FieldChoices& choices) {
  ForAll(answer, [&](const pb::Message& message) {
    for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
      CheckField(message, *message.GetDescriptor()->field(i), choices);
    }
  });
}

// The same, written as JSON and read again, is the same answer.
void CheckReadsTheSame(const pb::Message& answer, const llm::FieldChoices& choices) {
  pb::util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  options.always_print_primitive_fields = true;
  std::string json;
  Require(pb::util::MessageToJsonString(answer, &json, options).ok(), "what was read can be written");
  const std::unique_ptr<pb::Message> again(answer.New());
  for (const llm::Fault& fault : llm::ReadAnswer(json, choices, *again)) {
    Require(fault.kind != llm::FaultKind::kWrong || IsEmptyList(fault, *answer.GetDescriptor()),
            "nothing is wrong with what was read, but " + fault.Sentence());
  }
  std::string difference;
  pb::util::MessageDifferencer differencer;
  differencer.ReportDifferencesToString(&difference);
  Require(differencer.Compare(answer, *again), "what was read is read the same again, but for " + difference);
}

const std::vector<const pb::Message*>& AnswerTypes() {
  using namespace model::v1;  // All answers in one list.
  static const std::vector<const pb::Message*> types = {
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

void ReadTyped(std::string_view text, const pb::Message& type) {
  const std::unique_ptr<pb::Message> answer(type.New());
  const std::vector<llm::Fault> faults = llm::ReadAnswer(text, SomeChoices(), *answer);
  CheckFaults(faults, *type.GetDescriptor());
  CheckLists(*answer);
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

constexpr char kSecret[] = "sk-secret-key";

void CheckFailure(const absl::Status& status) {
  Require(!status.message().empty(), "a refusal says why");
  Require(status.ToString().find(kSecret) == std::string::npos, "no error holds a key");
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

// ---- A reply of the chat protocol from whoever passes for a server, streamed or at once.

void ReadReply(std::string_view bytes) {
  if (bytes.empty()) return;
  const unsigned char first = static_cast<unsigned char>(bytes.front());
  bytes.remove_prefix(1);
  const std::string address = "http://model", model = "m";
  const llm::ChatRequest request;
  const llm::Confidential confidential{.secrets = {kSecret}, .messages = {}};
  for (const bool streamed : {false, true}) {
    const auto reply = llm::ReadReply(bytes, streamed, {address, request, confidential, model});
    if (!reply.ok()) CheckFailure(reply.status());
  }
  for (const std::string& event : llm::EventsOf(bytes)) {
    Require(event.size() <= bytes.size(), "an event is no longer than its stream");
  }
  const llm::ServerError error = llm::ReadServerError(bytes);
  CheckFailure(llm::StatusOf(400 + first, error, "http://model: HTTP", confidential));
  llm::IsRefusal(error);
}

}  // namespace flair::fuzz
