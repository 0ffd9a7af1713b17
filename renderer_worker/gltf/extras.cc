// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string_view>
#include <utility>

#include "absl/strings/ascii.h"
#include "fmt/format.h"
#include "renderer_worker/gltf/mesh_book.h"

namespace flair::renderer::gltf {
namespace {

using tinygltf::Value;

// An object of JSON whose empty texts are left out.
class Fields {
 public:
  Fields& Text(const char* name, std::string_view value) {
    if (!value.empty()) fields_[name] = Value(std::string(value));
    return *this;
  }
  Fields& Number(const char* name, double value) { return Set(name, Value(Rounded(value))); }
  Fields& Flag(const char* name, bool value) { return Set(name, Value(value)); }
  Fields& Set(const char* name, Value value) {
    fields_[name] = std::move(value);
    return *this;
  }
  Value Take() { return Value(std::move(fields_)); }

 private:
  Value::Object fields_;
};

// "primary" of OBJECT_ROLE_PRIMARY, after so long a prefix.
std::string WordOf(const std::string& name, size_t prefix) {
  return name.ends_with("_UNSPECIFIED") || name.size() < prefix ? "" : absl::AsciiStrToLower(name.substr(prefix));
}

Value StyleOf(const v1::ObjectStyle& style) {
  Fields fields;
  fields.Text("material", style.material()).Text("description", style.description());
  if (style.has_colour()) {
    const v1::Colour& c = style.colour();
    fields.Text("colour_name", c.name());
    fields.Text("colour", fmt::format("#{:02x}{:02x}{:02x}", std::clamp(c.red(), 0, 255), std::clamp(c.green(), 0, 255),
                                      std::clamp(c.blue(), 0, 255)));
  }
  return fields.Take();
}

// Ids of objects among a call's arguments; names of zones and walls may be the same words and are none.
std::vector<std::string> NamedObjects(const v1::ConstraintEdge& edge) {
  std::vector<std::string> ids;
  for (const v1::Argument& argument : edge.arguments()) {
    if (argument.name().starts_with("zone") || argument.name().starts_with("wall")) continue;
    if (argument.value().has_text()) ids.push_back(argument.value().text());
    if (argument.value().has_texts()) {
      ids.insert(ids.end(), argument.value().texts().items().begin(), argument.value().texts().items().end());
    }
  }
  std::ranges::sort(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

}  // namespace

Extras::Extras(const v1::SolvedLayout& layout) : layout_(layout) {
  for (int e = 0; e < layout.graph().edges_size(); ++e) {
    for (std::string& id : NamedObjects(layout.graph().edges(e))) edges_of_[std::move(id)].push_back(e);
  }
  for (const v1::Sentence& s : layout.graph().constraint_list().sentences()) sentences_[s.id()] = s.text();
  for (const v1::Opening& o : layout.graph().room().openings()) openings_[o.id()] = &o;
}

Value Extras::ConstraintOf(int edge) const {
  const v1::ConstraintEdge& call = layout_.graph().edges(edge);
  Fields fields;
  fields.Text("id", call.id()).Text("type", call.type());
  const auto sentence = sentences_.find(call.sentence_id());
  if (sentence != sentences_.end()) fields.Text("sentence", sentence->second);
  if (edge < layout_.edge_outcomes_size()) {
    const v1::EdgeOutcome& outcome = layout_.edge_outcomes(edge);
    const std::string verdict = WordOf(v1::OutcomeStatus_Name(outcome.status()), 15);
    fields.Text("verdict", verdict.empty() ? "unknown" : verdict).Text("reason", outcome.reason());
  }
  return fields.Take();
}

Value Extras::OfObject(const SceneObject& shown) const {
  const v1::Object& object = *shown.object;
  Fields fields;
  fields.Text("id", object.id()).Text("name", object.name()).Text("class", shown.furnishing.class_name);
  fields.Text("category", object.category())
      .Text("zone", object.zone_id())
      .Text("role", WordOf(v1::ObjectRole_Name(object.role()), 12));
  fields.Text("kind", WordOf(v1::ObjectKind_Name(object.kind()), 12))
      .Text("host", object.host_id())
      .Text("description", object.description());
  fields.Flag("requested", object.requested()).Flag("walk_over", object.walk_over());
  fields.Text("asset", shown.furnishing.asset_id).Text("asset_licence", shown.furnishing.asset_licence);
  Fields size;
  size.Number("width_m", object.width_m()).Number("depth_m", object.depth_m()).Number("height_m", object.height_m());
  fields.Set("size", size.Take());
  const v1::Placement& p = shown.placement;
  Fields placement;
  placement.Number("x_m", p.x_m()).Number("y_m", p.y_m()).Number("z_m", p.z_m()).Number("theta_rad", p.theta_rad());
  fields.Set("placement", placement.Take());
  if (shown.style != nullptr) fields.Set("style", StyleOf(*shown.style));
  const auto edges = edges_of_.find(object.id());
  if (edges != edges_of_.end()) {
    Value::Array constraints;
    for (const int edge : edges->second) constraints.push_back(ConstraintOf(edge));
    fields.Set("constraints", Value(std::move(constraints)));
  }
  return fields.Take();
}

Value Extras::OfShellPart(const ShellPart& part) const {
  Fields fields;
  fields.Text("id", part.id).Text("class", NameOf(part.kind));
  const auto& walls = layout_.graph().room().walls();
  if (part.wall >= 0 && part.wall < walls.size()) fields.Text("wall", walls[part.wall].name());
  const auto opening = openings_.find(part.id);
  if (opening != openings_.end()) {
    const v1::Opening& o = *opening->second;
    fields.Number("offset_m", o.offset_m()).Number("width_m", o.width_m());
    fields.Number("sill_height_m", o.sill_height_m()).Number("head_height_m", o.head_height_m());
    fields.Text("description", o.description());
  }
  return fields.Take();
}

Value Extras::OfAsset(const Scene& scene, const GlbMetadata& metadata) {
  const v1::LayoutGraph& graph = scene.layout->graph();
  Fields fields;
  fields.Text("job_id", metadata.job_id).Text("brief", metadata.brief_text);
  // As text: JSON's numbers end at 2^53.
  if (metadata.brief_seed.has_value()) fields.Text("seed", std::to_string(*metadata.brief_seed));
  fields.Text("layout_digest", metadata.layout_digest).Text("build", metadata.build);
  fields.Text("title", graph.room().title()).Text("room_type", graph.room().room_type());
  fields.Text("style", graph.style_sheet().name());
  fields.Number("room_height_m", graph.room().height_m());
  fields.Text("frame", "metres, y up, north is -z; an object's front looks along its node's +z");
  fields.Number("light_scale", kLightScale);
  return fields.Take();
}

}  // namespace flair::renderer::gltf
