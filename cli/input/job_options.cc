// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/job_options.h"

#include <google/protobuf/descriptor.h>

#include <filesystem>
#include <numbers>

#include "absl/strings/ascii.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "absl/strings/str_split.h"
#include "cli/input/command_line.h"
#include "cli/input/message_text.h"
#include "fmt/format.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair {
// job_flags.txt, embedded: name|path|flag|least|most|help.
std::string_view JobFlagTable();
}  // namespace flair

namespace flair::cli {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

// Options of one kind: what they are called, where they are in a JobSpec, and the first stage that takes them.
struct OptionGroup {
  std::string_view name;
  const char* field;
  std::string_view stage;
  // The only field that may be set; all when empty.
  std::string_view only;
};

constexpr OptionGroup kGroups[] = {{"optimizer", "solve_options", "solve", ""},
                                   {"renderer", "render_options", "render", ""},
                                   {"models", "model_options", "room", ""},
                                   {"brief", "brief", "brief", "seed"}};

// An option that is a flag of some commands, and may have a shorter name than its field: a line of job_flags.txt.
struct FlagOption {
  std::string name;
  std::string path;
  std::string flag;
  // Where a flag's value is checked as it is read.
  double least = 0, most = 0;
  std::string help;
};

const std::vector<FlagOption>& FlagOptions() {
  static const std::vector<FlagOption>& options = *[] {
    auto* const made = new std::vector<FlagOption>;
    for (const auto line : absl::StrSplit(std::string(JobFlagTable()), '\n', absl::SkipEmpty())) {
      const std::vector<std::string> cells = absl::StrSplit(line, '|');
      FlagOption& option = made->emplace_back(FlagOption{cells[0], cells[1], cells[2], 0, 0, cells[5]});
      (void)(absl::SimpleAtod(cells[3], &option.least) && absl::SimpleAtod(cells[4], &option.most));
    }
    return made;
  }();
  return options;
}

const FlagOption* FindFlag(std::string_view text, std::string FlagOption::*member) {
  for (const FlagOption& known : FlagOptions()) {
    if (known.*member == text) return &known;
  }
  return nullptr;
}

void AddNames(const std::string& path, const FieldDescriptor& field, std::string_view only,
              std::vector<OptionName>& names) {
  if (HoldsOptions(field)) {
    for (int i = 0; i < field.message_type()->field_count(); ++i) {
      const FieldDescriptor& part = *field.message_type()->field(i);
      if (only.empty() || part.name() == only) AddNames(fmt::format("{}.{}", path, part.name()), part, "", names);
    }
  } else if (IsValue(field)) {
    const FlagOption* const known = FindFlag(path, &FlagOption::path);
    names.push_back({known == nullptr ? path : known->name, ValuesInWords(field)});
  }
}

std::vector<OptionName> NamesOf(const OptionGroup& group) {
  std::vector<OptionName> names;
  AddNames(std::string(group.name), *v1::JobSpec::descriptor()->FindFieldByName(group.field), group.only, names);
  return names;
}

const OptionGroup* GroupOf(std::string_view path) {
  for (const OptionGroup& group : kGroups) {
    if (path.substr(0, path.find('.')) == group.name) return &group;
  }
  return nullptr;
}

// A field at the end of a path, and the message that it is in, which is made on the way; null when there is none.
struct Place {
  Message* message = nullptr;
  const FieldDescriptor* field = nullptr;
};
Place Find(std::string_view path, Message& message) {
  const size_t dot = path.find('.');
  const FieldDescriptor* field = message.GetDescriptor()->FindFieldByName(std::string(path.substr(0, dot)));
  if (field == nullptr) return {};
  if (dot == std::string_view::npos) return IsValue(*field) ? Place{&message, field} : Place{};
  if (!HoldsOptions(*field)) return {};
  return Find(path.substr(dot + 1), *message.GetReflection()->MutableMessage(&message, field));
}

Place FindOption(std::string_view name, v1::JobSpec& spec) {
  const FlagOption* const known = FindFlag(name, &FlagOption::name);
  const std::string_view path = known == nullptr ? name : std::string_view(known->path);
  const OptionGroup* const group = GroupOf(path);
  if (group == nullptr || path.size() <= group->name.size()) return {};
  const std::string_view rest = path.substr(group->name.size() + 1);
  if (!group->only.empty() && rest != group->only) return {};
  return Find(fmt::format("{}.{}", group->field, rest), spec);
}

absl::Status NoSuchOption(const std::string& name) {
  const OptionGroup* const group = GroupOf(name);
  const auto text = [](std::string* out, const OptionName& option) { *out += option.name; };
  return InvalidArgument("--set {}: no such option; expected one of {}", name,
                         absl::StrJoin(group == nullptr ? OptionNames() : NamesOf(*group), ", ", text));
}

// "NAME=VALUE" of --lambda and --tolerance, which are options below `group`.
absl::Status SetMember(const char* flag, const std::string& group, const std::string& text, v1::JobSpec& spec) {
  if (!text.ends_with('=') && SetOption(group + text, spec).ok()) return absl::OkStatus();
  std::vector<std::string> names;
  for (const OptionName& option : OptionNames()) {
    if (option.name.starts_with(group)) names.push_back(option.name.substr(group.size()));
  }
  return InvalidArgument("{}: {}: expected NAME=VALUE, a number for one of {}", flag, text, fmt::join(names, ", "));
}

}  // namespace

std::vector<OptionName> OptionNames() {
  std::vector<OptionName> names;
  for (const OptionGroup& group : kGroups) {
    for (OptionName& name : NamesOf(group)) names.push_back(std::move(name));
  }
  return names;
}

absl::StatusOr<std::string_view> SetOption(const std::string& assignment, v1::JobSpec& spec) {
  const size_t equals = assignment.find('=');
  const std::string name(absl::StripAsciiWhitespace(assignment.substr(0, equals)));
  if (equals == std::string::npos) {
    return InvalidArgument("--set {}: expected NAME=VALUE, such as optimizer.restarts=500", assignment);
  }
  // On a copy: what fails must not leave a message that was made on the way.
  v1::JobSpec changed = spec;
  const Place place = FindOption(name, changed);
  if (place.message == nullptr) return NoSuchOption(name);
  const std::string value(absl::StripAsciiWhitespace(assignment.substr(equals + 1)));
  if (!SetValue(value, *place.field, *place.message)) {
    return InvalidArgument("--set {}: {}: expected {}", name, value, ValuesInWords(*place.field));
  }
  spec = std::move(changed);
  return GroupOf(name)->stage;
}

JobFlags::JobFlags(CLI::App& command, const std::vector<Choice>& choices, const std::string& group)
    : Options(command, group) {
  for (const auto& [name, help] : choices) {
    const FlagOption& option = *FindFlag(name, &FlagOption::name);
    Given& given = given_.emplace_back(name);
    const std::string text = help.empty() ? option.help : help;
    v1::JobSpec spec;
    const FieldDescriptor& field = *FindOption(name, spec).field;
    if (field.cpp_type() == FieldDescriptor::CPPTYPE_BOOL) {
      given.flag = command
                       .add_flag_callback(
                           option.flag, [&given] { given.text = "true"; }, text)
                       ->group(group);
      continue;
    }
    given.flag = Bind(option.flag, given.text, text);
    if (option.most == 0) continue;
    const bool is_whole = field.message_type() == nullptr && field.cpp_type() != FieldDescriptor::CPPTYPE_DOUBLE;
    given.flag->check(is_whole ? WholeNumber(static_cast<int64_t>(option.least), static_cast<int64_t>(option.most))
                               : Number(option.least, option.most));
  }
}

absl::Status JobFlags::Set(v1::JobSpec& spec) const {
  for (const Given& given : given_) {
    if (given.flag->count() == 0) continue;
    const Place place = FindOption(given.option, spec);
    const bool is_ratio = given.option == "renderer.scale" && given.text.starts_with("1:");
    if (SetValue(is_ratio ? given.text.substr(2) : given.text, *place.field, *place.message)) continue;
    return InvalidArgument("{}: {}: expected {}", given.flag->get_name(), given.text, ValuesInWords(*place.field));
  }
  return absl::OkStatus();
}

std::string JobFlags::InFlags(const std::string& message) const {
  std::vector<std::pair<std::string, std::string>> words;
  for (const Given& given : given_) {
    const std::string_view path = FindFlag(given.option, &FlagOption::name)->path;
    words.emplace_back(fmt::format("options{}", path.substr(path.find('.'))), given.flag->get_name());
  }
  return absl::StrReplaceAll(message, words);
}

SolveFlags::SolveFlags(CLI::App& command)
    : JobFlags(command, {{"optimizer.seed"},
                         {"optimizer.restarts"},
                         {"optimizer.threads"},
                         {"optimizer.variants"},
                         {"optimizer.path_width"},
                         {"optimizer.misfits"},
                         {"optimizer.time_limit"},
                         {"optimizer.contradictions"}}) {}

absl::StatusOr<v1::SolveOptions> ReadSolveFlags(const SolveFlags& flags) {
  v1::JobSpec spec;
  v1::SolveOptions& options = *spec.mutable_solve_options();
  if (!flags.file.empty()) {
    RETURN_IF_ERROR(ReadTextMessage("--options", flags.file,
                                    "fields of SolveOptions, such as: max_restart_count: 8 lambdas { balanced: 0 }",
                                    options));
  }
  RETURN_IF_ERROR(flags.Set(spec));
  for (const std::string& text : flags.lambdas) {
    RETURN_IF_ERROR(SetMember("--lambda", "optimizer.lambdas.", text, spec));
  }
  for (const std::string& text : flags.tolerances) {
    RETURN_IF_ERROR(SetMember("--tolerance", "optimizer.tolerances.", text, spec));
  }
  if (!spec.solve_options().has_seed()) spec.mutable_solve_options()->set_seed(0);
  return spec.solve_options();
}

RenderFlags::RenderFlags(CLI::App& command)
    : JobFlags(command, {{"renderer.view"},
                         {"renderer.size"},
                         {"renderer.dpi"},
                         {"renderer.paper"},
                         {"renderer.scale"},
                         {"renderer.layers"},
                         {"renderer.samples"},
                         {"renderer.seed"},
                         {"renderer.camera.eye_m"},
                         {"renderer.camera.target_m"}}) {}

absl::StatusOr<v1::PreviewView> ViewOfName(const std::string& name) {
  const auto* const view = FindWord(*v1::PreviewView_descriptor(), name);
  if (view != nullptr) return static_cast<v1::PreviewView>(view->number());
  const auto& field = *v1::RenderOptions::descriptor()->FindFieldByName("view");
  return InvalidArgument("--view: {}: expected {}", name, ValuesInWords(field));
}

absl::StatusOr<v1::PreviewFormat> FormatOfFile(const std::string& path) {
  constexpr std::pair<const char*, v1::PreviewFormat> kEndings[] = {
      {".png", v1::PREVIEW_FORMAT_PNG},  {".jpg", v1::PREVIEW_FORMAT_JPEG},  {".jpeg", v1::PREVIEW_FORMAT_JPEG},
      {".tif", v1::PREVIEW_FORMAT_TIFF}, {".tiff", v1::PREVIEW_FORMAT_TIFF}, {".exr", v1::PREVIEW_FORMAT_EXR},
      {".svg", v1::PREVIEW_FORMAT_SVG},  {".pdf", v1::PREVIEW_FORMAT_PDF}};
  const std::string ending = absl::AsciiStrToLower(std::filesystem::path(path).extension().string());
  for (const auto& [known, format] : kEndings) {
    if (ending == known) return format;
  }
  return InvalidArgument("--out: {}: its extension chooses the format: png, jpg, jpeg, tif, tiff, exr, svg, pdf{}",
                         path,
                         ending == ".glb" ? "; for a 3D scene: flair export scene LAYOUT --format glb --out FILE" : "");
}

absl::StatusOr<v1::RenderOptions> ReadRenderFlags(const RenderFlags& flags, const std::string& out) {
  v1::JobSpec spec;
  v1::RenderOptions& options = *spec.mutable_render_options();
  options.set_view(v1::PREVIEW_VIEW_PLAN);
  RETURN_IF_ERROR(flags.Set(spec));
  ASSIGN_OR_RETURN(const v1::PreviewFormat format, FormatOfFile(out));
  options.set_format(format);
  if (flags.field_of_view_deg > 0) {
    options.mutable_camera()->set_field_of_view_rad(flags.field_of_view_deg * std::numbers::pi / 180);
  }
  const absl::Status good = Validate(options);
  if (good.ok()) return options;
  return absl::InvalidArgumentError(absl::StrReplaceAll(flags.InFlags(std::string(good.message())),
                                                        {{"options.camera.field_of_view_rad", "--fov (in radians)"},
                                                         {"options.camera", "--camera"},
                                                         {"options.format", "--out"},
                                                         {"size_px", "--size"}}));
}

}  // namespace flair::cli
