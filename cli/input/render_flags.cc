// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/render_flags.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <numbers>
#include <utility>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_replace.h"
#include "absl/strings/str_split.h"
#include "fmt/format.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

constexpr std::pair<const char*, v1::PreviewView> kViews[] = {{"plan", v1::PREVIEW_VIEW_PLAN},
                                                              {"birdseye", v1::PREVIEW_VIEW_BIRDSEYE},
                                                              {"perspective", v1::PREVIEW_VIEW_PERSPECTIVE}};

constexpr std::pair<const char*, v1::PreviewFormat> kEndings[] = {
    {"png", v1::PREVIEW_FORMAT_PNG},  {"jpg", v1::PREVIEW_FORMAT_JPEG},  {"jpeg", v1::PREVIEW_FORMAT_JPEG},
    {"tif", v1::PREVIEW_FORMAT_TIFF}, {"tiff", v1::PREVIEW_FORMAT_TIFF}, {"exr", v1::PREVIEW_FORMAT_EXR},
    {"svg", v1::PREVIEW_FORMAT_SVG},  {"pdf", v1::PREVIEW_FORMAT_PDF}};

constexpr std::pair<const char*, v1::PlanLayer> kLayers[] = {{"floor_pieces", v1::PLAN_LAYER_FLOOR_PIECES},
                                                             {"tertiary", v1::PLAN_LAYER_TERTIARY},
                                                             {"zones", v1::PLAN_LAYER_ZONES},
                                                             {"dimensions", v1::PLAN_LAYER_DIMENSIONS},
                                                             {"constraints", v1::PLAN_LAYER_CONSTRAINTS},
                                                             {"circulation", v1::PLAN_LAYER_CIRCULATION}};

template <typename Table>
std::string NamesOf(const Table& table) {
  std::string names;
  for (const auto& [name, value] : table) names += fmt::format("{}{}", names.empty() ? "" : ", ", name);
  return names;
}

// A whole number or a decimal one, nothing after it.
template <typename Number>
bool Read(std::string_view text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

absl::Status ReadVector(const char* flag, const std::string& text, google::protobuf::RepeatedField<double>& vector) {
  for (const absl::string_view part : absl::StrSplit(text, ',')) {
    double value = 0;
    const absl::string_view bare = absl::StripAsciiWhitespace({part.data(), part.size()});
    if (!Read({bare.data(), bare.size()}, value)) {
      vector.Clear();
      break;
    }
    vector.Add(value);
  }
  if (vector.size() == 3) return absl::OkStatus();
  return absl::InvalidArgumentError(
      fmt::format("{}: {}: should be x,y,z in metres, such as 2,-1.5,4 (x east, y north, z up)", flag, text));
}

absl::Status ReadCamera(const RenderFlags& flags, v1::RenderOptions& options) {
  if (flags.camera.empty() != flags.look_at.empty()) {
    return absl::InvalidArgumentError(fmt::format("--{} goes with --{}: a camera is at a place and looks at one",
                                                  flags.camera.empty() ? "look-at" : "camera",
                                                  flags.camera.empty() ? "camera" : "look-at"));
  }
  if (flags.camera.empty()) {
    if (!flags.field_of_view_deg) return absl::OkStatus();
    return absl::InvalidArgumentError("--fov goes with --camera and --look-at");
  }
  v1::ViewCamera& camera = *options.mutable_camera();
  RETURN_IF_ERROR(ReadVector("--camera", flags.camera, *camera.mutable_eye_m()));
  RETURN_IF_ERROR(ReadVector("--look-at", flags.look_at, *camera.mutable_target_m()));
  if (flags.field_of_view_deg) camera.set_field_of_view_rad(*flags.field_of_view_deg * std::numbers::pi / 180);
  return absl::OkStatus();
}

absl::Status ReadLayers(const std::string& text, v1::RenderOptions& options) {
  if (text.empty()) return absl::OkStatus();
  for (const absl::string_view part : absl::StrSplit(text, ',')) {
    std::string name(part);
    std::replace(name.begin(), name.end(), '-', '_');
    if (name == "all") {
      options.clear_layers();
      for (const auto& [ignored, layer] : kLayers) options.add_layers(layer);
      return absl::OkStatus();
    }
    const auto* found =
        std::find_if(std::begin(kLayers), std::end(kLayers), [&](const auto& layer) { return layer.first == name; });
    if (found == std::end(kLayers)) {
      return absl::InvalidArgumentError(
          fmt::format("--layers: {}: is no layer; {}, or all", std::string(part), NamesOf(kLayers)));
    }
    if (std::find(options.layers().begin(), options.layers().end(), found->second) == options.layers().end())
      options.add_layers(found->second);
  }
  return absl::OkStatus();
}

absl::Status ReadSheet(const RenderFlags& flags, v1::RenderOptions& options) {
  if (flags.paper == "a4" || flags.paper == "A4") options.set_paper(v1::PAPER_SIZE_A4);
  if (flags.paper == "a3" || flags.paper == "A3") options.set_paper(v1::PAPER_SIZE_A3);
  if (!flags.paper.empty() && options.paper() == v1::PAPER_SIZE_UNSPECIFIED)
    return absl::InvalidArgumentError(fmt::format("--paper: {}: is no paper here; a4 or a3", flags.paper));
  if (flags.scale.empty()) return absl::OkStatus();
  std::string_view number = flags.scale;
  if (number.starts_with("1:")) number.remove_prefix(2);
  int denominator = 0;
  if (!Read(number, denominator))
    return absl::InvalidArgumentError(fmt::format("--scale: {}: should be 1:N or N, such as 1:50", flags.scale));
  options.set_scale_denominator(denominator);
  return absl::OkStatus();
}

// The words of flags for those of fields.
std::string InFlags(const std::string& message) {
  return absl::StrReplaceAll(message, {{"options.size_px", "--size"},
                                       {"options.dpi", "--dpi"},
                                       {"options.paper", "--paper"},
                                       {"options.scale_denominator", "--scale"},
                                       {"options.layers", "--layers"},
                                       {"options.sample_count", "--samples"},
                                       {"options.seed", "--seed"},
                                       {"options.camera.eye_m", "--camera"},
                                       {"options.camera.target_m", "--look-at"},
                                       {"options.camera.field_of_view_rad", "--fov (in radians)"},
                                       {"options.camera", "--camera"},
                                       {"options.format", "--out"},
                                       {"size_px", "--size"}});
}

}  // namespace

void AddRenderFlags(CLI::App& command, RenderFlags& flags) {
  command.add_option("--view", flags.view, "What is drawn: plan, birdseye or perspective (plan)")->type_name("VIEW");
  command.add_option("--size", flags.size_px, "Longer side in pixels, 256 to 8192 (plan 1600, views 1024)")
      ->type_name("PX");
  command.add_option("--dpi", flags.dpi, "Plans: dots per inch of paper, 36 to 1200, instead of --size")
      ->type_name("N");
  command.add_option("--paper", flags.paper, "Plans: a4 or a3 (a3); the room decides which way up")->type_name("SIZE");
  command.add_option("--scale", flags.scale, "Plans: 1:N, N 5 to 1000 (the largest common one that fits the paper)")
      ->type_name("1:N");
  command
      .add_option("--layers", flags.layers,
                  "Plans: some of floor_pieces, tertiary, zones, dimensions, constraints, circulation, with commas; or "
                  "all (without the flag: the first four)")
      ->type_name("A,B");
  command.add_option("--samples", flags.samples, "Views: paths of light per pixel, 1 to 4096 (16)")->type_name("N");
  command.add_option("--seed", flags.seed, "Views: another grain (0)")->type_name("N");
  command.add_option("--camera", flags.camera, "Views: where the camera is, metres in the room")->type_name("X,Y,Z");
  command.add_option("--look-at", flags.look_at, "Views: what it looks at")->type_name("X,Y,Z");
  command.add_option("--fov", flags.field_of_view_deg, "Views: its vertical angle in degrees, 6 to 148 (57.3)")
      ->type_name("DEG");
}

absl::StatusOr<v1::PreviewView> ViewOfName(const std::string& name) {
  for (const auto& [known, view] : kViews) {
    if (name == known) return view;
  }
  return absl::InvalidArgumentError(fmt::format("--view: {}: is no view; {}", name, NamesOf(kViews)));
}

absl::StatusOr<v1::PreviewFormat> FormatOfFile(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  if (!ending.empty()) ending.erase(0, 1);
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  for (const auto& [known, format] : kEndings) {
    if (ending == known) return format;
  }
  return absl::InvalidArgumentError(
      fmt::format("--out: {}: its ending says the format: {}{}", path, NamesOf(kEndings),
                  ending == "glb" ? "; for a 3D scene: flair export scene LAYOUT --format glb --out FILE" : ""));
}

absl::StatusOr<v1::RenderOptions> ReadRenderFlags(const RenderFlags& flags, const std::string& out) {
  v1::RenderOptions options;
  ASSIGN_OR_RETURN(const v1::PreviewView view, ViewOfName(flags.view));
  options.set_view(view);
  ASSIGN_OR_RETURN(const v1::PreviewFormat format, FormatOfFile(out));
  options.set_format(format);
  if (flags.size_px) options.set_size_px(*flags.size_px);
  if (flags.dpi) options.set_dpi(*flags.dpi);
  RETURN_IF_ERROR(ReadSheet(flags, options));
  RETURN_IF_ERROR(ReadLayers(flags.layers, options));
  if (flags.samples) options.set_sample_count(*flags.samples);
  if (flags.seed) options.set_seed(*flags.seed);
  RETURN_IF_ERROR(ReadCamera(flags, options));
  if (const absl::Status good = Validate(options); !good.ok())
    return absl::InvalidArgumentError(InFlags(std::string(good.message())));
  return options;
}

}  // namespace flair::cli
