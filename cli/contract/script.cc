// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/contract/script.h"

#include <google/protobuf/text_format.h>

#include <algorithm>
#include <cstdlib>

#include "absl/strings/escaping.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "absl/strings/str_split.h"
#include "cli/contract/checks_bytes.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/registry.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::contract {
namespace {

namespace pb = google::protobuf;

// Calls until something is true, at most.
constexpr int kMostCalls = 100;
constexpr size_t kShownOfValue = 120;

template <typename Named>
const auto& ByName(const Named& all, std::string_view name) {
  const auto found = std::ranges::find_if(all, [&](const auto& each) { return each.name() == name; });
  if (found == all.end()) std::abort();
  return *found;
}

data::CheckFile ReadChecks() {
  data::CheckFile file;
  MergeText(std::string(reinterpret_cast<const char*>(kCheckBytes), sizeof(kCheckBytes)), file);
  const v1::ConstraintCatalog catalog = optimizer::MakeCatalog();
  const auto add = [&file](const char* name, const std::string& text) {
    file.add_fragments()->set_name(name);
    file.mutable_fragments()->rbegin()->set_text(text);
  };
  add("catalogue", catalog.ShortDebugString());
  add("first_type", catalog.types(0).name());
  return file;
}

std::unique_ptr<pb::Message> NewMessage(const pb::Descriptor& type) {
  return std::unique_ptr<pb::Message>(pb::MessageFactory::generated_factory()->GetPrototype(&type)->New());
}

const pb::MethodDescriptor& MethodOf(const std::string& service, const std::string& call) {
  const auto* const found = pb::DescriptorPool::generated_pool()->FindServiceByName(service);
  const auto* const method = found == nullptr ? nullptr : found->FindMethodByName(call);
  if (method == nullptr) std::abort();
  return *method;
}

std::vector<std::string> Texts(const Values& values) {
  std::vector<std::string> texts;
  for (const Value& value : values) texts.push_back(value.text);
  return texts;
}

std::string Shown(const std::vector<std::string>& texts) {
  return absl::StrJoin(texts, ", ", [](std::string* out, const std::string& text) {
    *out += absl::CHexEscape(text.substr(0, kShownOfValue));
    if (text.size() > kShownOfValue) *out += "...";
  });
}

// Where two long texts begin to differ.
std::string Difference(const std::string& got, const std::string& wanted) {
  const auto at = static_cast<size_t>(std::ranges::mismatch(got, wanted).in1 - got.begin());
  const size_t from = at < kShownOfValue / 2 ? 0 : at - kShownOfValue / 2;
  return fmt::format("\"{}\" instead of \"{}\"", got.substr(from, kShownOfValue),
                     wanted.substr(std::min(from, wanted.size()), kShownOfValue));
}

// What `edit` says, at the part of the request; see data::Refusal.
void Spoil(const data::Refusal& refusal, const std::string& edit, pb::Message& request) {
  pb::Message& part = PartOf(request, refusal.at());
  std::string_view text = edit;
  while (text.starts_with('-')) {
    const std::string_view word = text.substr(1, text.find(' ') - 1);
    text.remove_prefix(std::min(text.size(), word.size() + 2));
    if (word.ends_with("[]")) {
      part.GetReflection()->RemoveLast(&part, &FieldOf(part, word.substr(0, word.size() - 2)));
    } else {
      part.GetReflection()->ClearField(&part, &FieldOf(part, word));
    }
  }
  MergeText(std::string(text), part);
}

std::string NamedBy(const data::Refusal& refusal) {
  if (!refusal.named().empty()) return refusal.named();
  const std::string_view field = std::string_view(refusal.edit()).substr(refusal.edit().starts_with('-') ? 1 : 0);
  const std::string end = refusal.at().substr(refusal.at().rfind('.') + 1);
  return fmt::format("{}{}{}", end, end.empty() ? "" : ".", field.substr(0, field.find_first_of(" :[")));
}

void AddRefusals(const data::Stage& stage, const data::Refusals& refusals, v1::Capability capability,
                 const std::shared_ptr<Run::Shared>& shared, Checks& checks) {
  for (const data::Refusal& refusal : refusals.cases()) {
    const std::string field = NamedBy(refusal);
    const auto run = [&stage, &refusals, &refusal, field, shared](Target& target) -> Finding {
      Run run(&target, *shared);
      const std::unique_ptr<pb::Message> bad = NewMessage(*MethodOf(stage.service(), refusals.call()).input_type());
      run.Fill(refusals.with(), *bad);
      Spoil(refusal, run.Inserted(refusal.edit(), true), *bad);
      const absl::Status status = target.AskForBytes(*bad).status();
      if (status.ok()) return Wrong("OK, with an answer");
      const bool named = std::string(status.message()).find(field) != std::string::npos;
      return absl::IsInvalidArgument(status) && named ? Kept() : Finding(status);
    };
    checks.push_back({.name = fmt::format("{} refuses {}", refusals.call(), refusal.what()),
                      .promise = data::PROMISE_ERRORS,
                      .sent = fmt::format("{} with {} ({})", refusals.call(), refusal.what(), field),
                      .right = fmt::format("INVALID_ARGUMENT with a message that names \"{}\"", field),
                      .run = run,
                      .capability = capability});
  }
}

// The RPCs about one job, batch or artifact, told from the fields of their requests.
void AddUnknownIds(const std::string& service, Checks& checks) {
  const auto& found = *pb::DescriptorPool::generated_pool()->FindServiceByName(service);
  for (int i = 0; i < found.method_count(); ++i) {
    const pb::MethodDescriptor& method = *found.method(i);
    // Lists take ids as filters: nothing matches one that is not there.
    if (method.name().starts_with("List")) continue;
    for (const char* name : {"job_id", "batch_id", "artifact_id"}) {
      const pb::FieldDescriptor* const id = method.input_type()->FindFieldByName(name);
      if (id == nullptr || id->is_repeated()) continue;
      const std::string sent = method.name() + " of an id that is not there";
      const auto run = [&method, id](Target& target) -> Finding {
        const std::unique_ptr<pb::Message> request = NewMessage(*method.input_type());
        request->GetReflection()->SetString(request.get(), id, std::string(64, '0'));
        const absl::Status status = target.AskForBytes(*request).status();
        return absl::IsNotFound(status) ? Kept() : Wrong(StatusText(status));
      };
      checks.push_back({sent + " is NOT_FOUND", data::PROMISE_ERRORS, sent, "NOT_FOUND", run});
      break;
    }
  }
}

}  // namespace

void MergeText(const std::string& text, pb::Message& message) {
  if (!pb::TextFormat::MergeFromString(text, &message)) std::abort();
}

const data::CheckFile& AllChecks() {
  static const auto& file = *new data::CheckFile(ReadChecks());
  return file;
}

Sample SampleOf(const data::Stage& stage) {
  const data::Sample& sample = stage.sample();
  const pb::MethodDescriptor& method = MethodOf(stage.service(), sample.call());
  const auto filled = [&method](const std::string& text) {
    Run::Shared nothing;
    std::shared_ptr<pb::Message> request = NewMessage(*method.input_type());
    Run(nullptr, nothing).Fill(text, *request);
    return request;
  };
  Sample made{.what = sample.what(), .request = filled(sample.with()), .fault = {}, .core = {}, .long_requests = {}};
  for (const std::string& text : sample.long_requests()) made.long_requests.push_back(filled(text));
  made.fault = [&sample, &method, request = made.request](const std::string& bytes) {
    std::unique_ptr<pb::Message> answer = NewMessage(*method.output_type());
    if (!answer->ParseFromString(bytes)) return "bytes that are no " + method.output_type()->name();
    Run::Shared nothing;
    return Run(nullptr, nothing).FaultOf(sample.expect(), *request, std::move(answer));
  };
  if (sample.stable_part().empty()) return made;
  made.core = [&sample, &method](const std::string& bytes) {
    if (sample.stable_part() == "*") return bytes;
    const std::unique_ptr<pb::Message> answer = NewMessage(*method.output_type());
    answer->ParseFromString(bytes);
    return absl::StrJoin(Texts(ValuesAt(*answer, sample.stable_part())), "\n");
  };
  return made;
}

Checks StageChecks(const data::Stage& stage) {
  Checks checks;
  const auto shared = std::make_shared<Run::Shared>();
  for (const data::Check& check : stage.checks()) {
    v1::Capability capability = v1::CAPABILITY_UNSPECIFIED;
    if (!check.capability().empty() && !v1::Capability_Parse(check.capability(), &capability)) std::abort();
    if (check.unknown_ids()) {
      AddUnknownIds(stage.service(), checks);
    } else if (check.has_refusals()) {
      AddRefusals(stage, check.refusals(), capability, shared, checks);
    } else {
      checks.push_back({check.name(), check.promise(), check.sent(), check.right(),
                        [&check, shared](Target& target) { return Run(&target, *shared).Do(check); }, capability});
    }
  }
  return checks;
}

Finding Run::Do(const data::Check& check) {
  for (const std::string& needed : check.needs()) {
    DoProcedure(needed);
    if (!shared_.outcomes[needed].answered) return Skipped(needed + " had no answer");
  }
  return Do(check.steps());
}

Finding Run::Do(const pb::RepeatedPtrField<data::Step>& steps) {
  for (const data::Step& step : steps) {
    if (Finding finding = Do(step); finding.verdict != Verdict::kKept) return finding;
  }
  return Kept();
}

Finding Run::DoProcedure(const std::string& name) {
  const data::Procedure& procedure = ByName(AllChecks().procedures(), name);
  if (!procedure.once()) return Do(procedure.steps());
  const auto known = shared_.outcomes.find(name);
  if (known != shared_.outcomes.end()) return known->second.finding;
  answered_ = true;
  const Finding finding = Do(procedure.steps());
  shared_.outcomes[name] = {finding, answered_};
  return finding;
}

Finding Run::Do(const data::Step& step) {
  Finding finding = !step.procedure().empty() ? DoProcedure(step.procedure())
                    : !step.action().empty()  ? ActionNamed(step.action())(*this)
                                              : Call(step);
  for (const data::Keep& keep : step.keep()) {
    if (finding.verdict != Verdict::kKept) break;
    const Values found = ValuesOf(keep.path());
    if (found.empty() && !keep.or_skip().empty()) return Skipped(keep.or_skip());
    Values& kept = shared_.kept[keep.name()];
    if (!keep.add()) kept.clear();
    kept.insert(kept.end(), found.begin(), found.end());
  }
  for (const data::Expect& expect : step.expect()) {
    if (finding.verdict == Verdict::kKept) finding = Meets(expect);
  }
  if (finding.verdict == Verdict::kBroken && finding.sent.empty()) finding.sent = step.sent();
  return finding;
}

Finding Run::Call(const data::Step& step) {
  const pb::MethodDescriptor& method = MethodOf(target_->options().service, step.call());
  std::vector<std::string> sent;
  for (const std::string& text : step.with()) {
    const std::shared_ptr<pb::Message> request = NewMessage(*method.input_type());
    Fill(text, *request);
    request_ = request;
    sent.push_back(request->SerializeAsString());
  }
  if (sent.empty()) sent.emplace_back();
  answers_.clear();
  for (int calls = 0; calls < kMostCalls; ++calls) {
    const auto received = target_->Exchange(method, sent, static_cast<size_t>(step.leave_after()));
    const std::string code = absl::StatusCodeToString(received.status().code());
    if (code == step.unless()) return Skipped("it answers " + code);
    const std::vector<std::string> right = absl::StrSplit(step.status().empty() ? "OK" : step.status(), '|');
    const bool named = received.status().message().find(step.named()) != absl::string_view::npos;
    answered_ = answered_ && received.ok();
    if (std::ranges::count(right, code) == 0 || !named) {
      return Wrong(received.ok() ? "OK, with an answer" : StatusText(received.status()));
    }
    if (!received.ok()) return Kept();
    for (const std::string& bytes : *received) {
      std::unique_ptr<pb::Message> answer = NewMessage(*method.output_type());
      if (!answer->ParseFromString(bytes)) {
        return DataLoss("the answer's {} bytes are no {}", bytes.size(), answer->GetTypeName());
      }
      answers_.push_back(std::move(answer));
    }
    if (step.until().empty() || Texts(ValuesAt(answers_, step.until())) == std::vector<std::string>{"true"}) {
      return Kept();
    }
  }
  return Wrong(fmt::format("{} calls, and not {}", kMostCalls, step.until()));
}

Values Run::ValuesOf(std::string_view path) const {
  Values values;
  for (const absl::string_view each : absl::StrSplit(absl::string_view(path.data(), path.size()), " | ")) {
    const std::string part(each);
    const Values found = part.starts_with('$') ? kept(part.substr(1)) : ValuesAt(answers_, part);
    values.insert(values.end(), found.begin(), found.end());
  }
  return values;
}

std::string Run::FaultOf(const pb::RepeatedPtrField<data::Expect>& expected, const pb::Message& request,
                         std::unique_ptr<pb::Message> answer) {
  request_ = std::shared_ptr<const pb::Message>(std::shared_ptr<void>(), &request);
  answers_.clear();
  answers_.push_back(std::move(answer));
  for (const data::Expect& expect : expected) {
    if (Finding finding = Meets(expect); finding.verdict == Verdict::kBroken) return finding.got;
  }
  return "";
}

Finding Run::Meets(const data::Expect& expect) {
  if (!expect.judge().empty()) return JudgeNamed(expect.judge())(*request_, *answers_.back());
  if (expect.relation() == data::RELATION_VALID) {
    return WrongIf(ValidationFault(PartOf(std::as_const(*answers_.back()), expect.path()), *request_));
  }
  const std::vector<std::string> got = Texts(ValuesOf(expect.path()));
  const std::string fault = expect.fault().empty() ? expect.path() : expect.fault();
  const std::string shown =
      got.empty() ? fault + (expect.fault().empty() ? ": nothing" : "") : fmt::format("{}: {}", fault, Shown(got));
  if (expect.has_least() || expect.has_most()) {
    const auto count = static_cast<int>(got.size());
    const bool too_few = expect.has_least() && count < expect.least();
    return too_few || (expect.has_most() && count > expect.most()) ? Wrong(shown) : Kept();
  }
  std::vector<std::string> given;
  for (const std::string& value : expect.values()) given.push_back(Inserted(value, false));
  if (!expect.kept().empty()) given = Texts(kept(expect.kept()));
  if (!expect.sent().empty()) given = Texts(ValuesAt(*request_, expect.sent()));
  if (Holds(expect.relation(), got, given)) return Kept();
  if (expect.relation() == data::RELATION_INCLUDES) {
    const auto missing =
        std::ranges::find_if(given, [&](const auto& one) { return std::ranges::count(got, one) == 0; });
    return Wrong(fmt::format("{}: \"{}\" is not among them", fault, *missing));
  }
  const bool both_long = got.size() == 1 && given.size() == 1 && got[0].size() > kShownOfValue;
  return Wrong(both_long ? fmt::format("{}: {}", fault, Difference(got[0], given[0])) : shown);
}

std::string Run::Inserted(std::string_view text, bool is_protobuf) {
  std::string inserted;
  for (size_t begin = text.find("${"); begin != std::string_view::npos; begin = text.find("${")) {
    const size_t end = text.find('}', begin);
    inserted += text.substr(0, begin);
    inserted += Insertion(std::string(text.substr(begin + 2, end - begin - 2)), is_protobuf);
    text.remove_prefix(end + 1);
  }
  return inserted.append(text);
}

std::string Run::Insertion(const std::string& name, bool is_protobuf) {
  if (name == "new") return fmt::format("\"{}\"", target_->NewRequestId());
  if (name == "run") {
    if (run_id_.empty()) run_id_ = target_->NewRequestId();
    return fmt::format("\"{}\"", run_id_);
  }
  if (const size_t star = name.find('*'); star != std::string::npos) {
    const std::string once = Insertion(name.substr(star + 1), is_protobuf);
    std::string copies;
    for (int i = 0; i < std::atoi(name.c_str()); ++i) copies += absl::StrReplaceAll(once, {{"#", std::to_string(i)}});
    return copies;
  }
  const auto kept = shared_.kept.find(name);
  if (kept == shared_.kept.end()) return Inserted(ByName(AllChecks().fragments(), name).text(), is_protobuf);
  return absl::StrJoin(kept->second, " ", [is_protobuf](std::string* out, const Value& value) {
    *out += value.quoted && is_protobuf ? fmt::format("\"{}\"", absl::CEscape(value.text)) : value.text;
  });
}

}  // namespace flair::contract
