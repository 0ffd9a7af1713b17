// SPDX-License-Identifier: GPL-3.0-or-later
// Checks as data (protos/flair/checks/v1/checks.proto) put to a server.
#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/contract/check.h"
#include "cli/contract/target.h"
#include "flair/checks/v1/checks.pb.h"

namespace flair::contract {

// Parts of messages by path and what may be said of them, as Expect in protos/flair/checks/v1/checks.proto has it.

// A field's value as text: a number, a word, a message as protobuf text on one line.
struct Value {
  std::string text;
  // A string or bytes, which stand in quotes in protobuf text.
  bool quoted = false;

  bool operator==(const Value&) const = default;
};
using Values = std::vector<Value>;

using Messages = std::vector<std::unique_ptr<google::protobuf::Message>>;

// Ends the program when the message has no such field: paths are this library's own.
const google::protobuf::FieldDescriptor& FieldOf(const google::protobuf::Message& message, std::string_view name);

// The values at the path. Messages and optional fields that are not set have none.
Values ValuesAt(const google::protobuf::Message& message, std::string_view path);
// The path begins with the brackets of a list, or means the last one.
Values ValuesAt(const Messages& answers, std::string_view path);

// The message at a path of names and numbers: "layout_graph.object_list.objects[0]". Made when it is not there.
google::protobuf::Message& PartOf(google::protobuf::Message& message, std::string_view path);
// The same, to read; the default message when it is not there.
const google::protobuf::Message& PartOf(const google::protobuf::Message& message, std::string_view path);

// Whether the values are so to those that are given; not for RELATION_VALID.
bool Holds(checks::v1::Relation relation, const std::vector<std::string>& got, const std::vector<std::string>& given);

namespace data = ::flair::checks::v1;

// All checks: checks.textproto, which is part of the program.
const data::CheckFile& AllChecks();

// A request for the checks that are the same for all stages; see data::Sample.
struct Sample {
  std::string what;
  std::shared_ptr<const google::protobuf::Message> request;
  // What is wrong with the answer's bytes; empty when nothing is.
  std::function<std::string(const std::string& bytes)> fault;
  // The part of good bytes that must be equal for equal requests of a server that claims DETERMINISTIC; unset when the
  // answer changes by itself.
  std::function<std::string(const std::string& bytes)> core;
  std::vector<std::shared_ptr<const google::protobuf::Message>> long_requests;
};
Sample SampleOf(const data::Stage& stage);

// The same of all stages, before and after those of the stage alone.
Checks ServerChecks(const Sample& sample);
Checks CallerChecks(const Sample& sample);

// What servers of this stage alone promise. They share what `once` procedures find: make them anew for another server.
Checks StageChecks(const data::Stage& stage);

// Merges protobuf text of this library's own; ends the program when it does not fit.
void MergeText(const std::string& text, google::protobuf::Message& message);

// One check under way: what it has kept, and what it has asked last.
class Run {
 public:
  // What procedures that are done once came to, and what was kept.
  struct Shared {
    struct Outcome {
      Finding finding;
      bool answered = false;
    };
    std::map<std::string, Outcome> outcomes;
    std::map<std::string, Values> kept;
  };

  // Without a target it only fills in texts and judges answers.
  Run(Target* target, Shared& shared) : target_(target), shared_(shared) {}

  Finding Do(const data::Check& check);

  Target& target() { return *target_; }
  const Values& kept(const std::string& name) const { return shared_.kept[name]; }
  // Merges the text into the request; what it inserts is in data::Step.with.
  void Fill(const std::string& text, google::protobuf::Message& request) { MergeText(Inserted(text, true), request); }
  // With ${name} replaced: texts get quotes when it is protobuf text.
  std::string Inserted(std::string_view text, bool is_protobuf);
  // What is wrong with an answer; empty when nothing is.
  std::string FaultOf(const google::protobuf::RepeatedPtrField<data::Expect>& expected,
                      const google::protobuf::Message& request, std::unique_ptr<google::protobuf::Message> answer);

 private:
  Finding Do(const google::protobuf::RepeatedPtrField<data::Step>& steps);
  Finding Do(const data::Step& step);
  Finding DoProcedure(const std::string& name);
  Finding Call(const data::Step& step);
  Finding Meets(const data::Expect& expect);
  Values ValuesOf(std::string_view path) const;
  std::string Insertion(const std::string& name, bool is_protobuf);

  Target* const target_;
  Shared& shared_;
  std::string run_id_;
  bool answered_ = true;
  Messages answers_;
  std::shared_ptr<const google::protobuf::Message> request_;
};

// judges.cc: how the answer to a request is; and steps of more than one call.
using Judge = Finding (*)(const google::protobuf::Message& request, const google::protobuf::Message& answer);
using Action = Finding (*)(Run& run);
Judge JudgeNamed(const std::string& name);
Action ActionNamed(const std::string& name);
// What is wrong with a part of an answer, by the rules of room/validation; some rules need what was asked.
std::string ValidationFault(const google::protobuf::Message& part, const google::protobuf::Message& request);

}  // namespace flair::contract
