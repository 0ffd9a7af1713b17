// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>

#include "renderer_worker/furniture/piece.h"
#include "renderer_worker/scene/surfaces.h"

// Which part of a piece takes which material and colour of its style.
namespace flair::renderer {
namespace {

bool IsHard(const BaseMaterial& m) { return m.kind != MaterialKind::kCloth; }
bool IsCloth(const BaseMaterial& m) { return m.kind == MaterialKind::kCloth; }
bool IsMetal(const BaseMaterial& m) { return m.kind == MaterialKind::kMetal; }

using Words = std::vector<const BaseMaterial*>;

template <typename Predicate>
const BaseMaterial* First(const Words& named, Predicate predicate) {
  const auto at = std::find_if(named.begin(), named.end(), [&](const BaseMaterial* m) { return predicate(*m); });
  return at != named.end() ? *at : nullptr;
}

// What the style names, most telling first.
struct Choice {
  const BaseMaterial* hard = nullptr;
  const BaseMaterial* soft = nullptr;
  const BaseMaterial* metal = nullptr;
};

Choice Choose(const Words& named, const ClassLook& look) {
  Choice choice{First(named, IsHard), First(named, IsCloth), First(named, IsMetal)};
  // "walnut and brass": the metal is for the fittings when there is something else for the body, and where the body
  // is not of metal by nature.
  if (choice.hard != nullptr && IsMetal(*choice.hard) && !IsMetal(BaseMaterialOf(look.hard))) {
    const BaseMaterial* body = First(named, [](const BaseMaterial& m) { return IsHard(m) && !IsMetal(m); });
    if (body != nullptr) choice.hard = body;
  }
  return choice;
}

// Colours say which part they are of: "dark walnut" is a wood's, "antique brass" a metal's.
enum class Part { kHard, kSoft, kMetal };

Part PartColoured(const ClassLook& look, const Choice& choice, const Words& named, const v1::Colour& colour) {
  const Words said = MaterialsInWords(colour.name());
  if (!said.empty() && IsCloth(*said.front())) return Part::kSoft;
  const bool hard_is_metal = IsMetal(choice.hard != nullptr ? *choice.hard : BaseMaterialOf(look.hard));
  if (!said.empty() && IsMetal(*said.front())) return hard_is_metal ? Part::kHard : Part::kMetal;
  if (!said.empty()) return Part::kHard;
  if (look.dominant == ClassLook::Dominant::kHard) {
    return choice.soft != nullptr && choice.hard == nullptr ? Part::kSoft : Part::kHard;
  }
  // Upholstery of which only wood or metal is named, in a brown that suits the wood: the wood's.
  if (!named.empty() && choice.soft == nullptr && choice.hard != nullptr && choice.hard->kind == MaterialKind::kWood) {
    const Vec3 difference = LinearOf(colour) - choice.hard->look.colour;
    if (Length(difference) < 0.12F) return Part::kHard;
  }
  return Part::kSoft;
}

}  // namespace

Palette PaletteOf(const ClassLook& look, const v1::Object& object, const v1::ObjectStyle* style) {
  Words named = style != nullptr ? MaterialsInWords(style->material()) : Words();
  const Words by_name = MaterialsInWords(object.name());
  named.insert(named.end(), by_name.begin(), by_name.end());
  const Choice choice = Choose(named, look);
  const BaseMaterial& hard = choice.hard != nullptr ? *choice.hard : BaseMaterialOf(look.hard);
  const BaseMaterial& soft = choice.soft != nullptr ? *choice.soft : BaseMaterialOf(look.soft);
  const BaseMaterial& metal = choice.metal != nullptr ? *choice.metal : BaseMaterialOf(look.metal);
  Palette palette;
  palette.hard = hard.look, palette.soft = soft.look, palette.metal = metal.look;
  if (look.hard_colour != 0 && choice.hard == nullptr) palette.hard = Coloured(hard, LinearHex(look.hard_colour));
  if (look.soft_colour != 0 && choice.soft == nullptr) palette.soft = Coloured(soft, LinearHex(look.soft_colour));
  if (style != nullptr && style->has_colour()) {
    palette.styled = true;
    const Vec3 colour = LinearOf(style->colour());
    switch (PartColoured(look, choice, named, style->colour())) {
      case Part::kHard:
        palette.hard = Coloured(hard, colour);
        break;
      case Part::kSoft:
        palette.soft = Coloured(soft, colour);
        break;
      case Part::kMetal:
        palette.metal = Coloured(metal, colour);
        break;
    }
  }
  // Glass as the body of a piece that is not of glass by nature is thick enough to be seen.
  if (palette.hard.opacity < 1 && hard.name != look.hard) palette.hard.opacity = 0.35F;
  palette.hard.name += ", body";
  palette.soft.name += ", soft";
  palette.metal.name += ", fittings";
  palette.colour = look.dominant == ClassLook::Dominant::kHard ? palette.hard.colour : palette.soft.colour;
  palette.pale = palette.soft;
  palette.pale.name = "pale " + palette.soft.name;
  palette.pale.colour = Blend(palette.soft.colour, {0.80F, 0.78F, 0.73F}, 0.82F);
  palette.pale.second_colour = palette.pale.colour * 0.9F;
  palette.accent = Shaded(palette.soft, 0.55F, "deep");
  return palette;
}

}  // namespace flair::renderer
