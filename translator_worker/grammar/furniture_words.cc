// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/furniture_words.h"

#include "absl/strings/str_split.h"

namespace flair::translator {
namespace {

// One group of synonyms a line.
constexpr char kSynonyms[] =
    R"(sofa|couch|settee|loveseat|sectional|corner sofa
nightstand|bedside table|night table|night stand|bedside cabinet
bookshelf|bookcase|book shelf|shelving unit|shelf|shelving|bookshelf unit|shelf unit|open shelf
wardrobe|closet|armoire|clothes cupboard
dresser|chest of drawers|drawer unit|drawer chest
tv stand|tv unit|television stand|media console|media unit|tv console|tv cabinet|tv bench|entertainment unit|entertainment center|entertainment console
television|tv|tv screen|television screen|screen
refrigerator|fridge|fridge freezer|freezer|icebox
cooker|stove|range|oven|hob|cooktop|stove top
kitchen sink|sink
washbasin|basin|vanity|bathroom sink|wash basin|sink vanity|vanity unit|sink
toilet|wc|lavatory
bathtub|bath|tub
desk chair|office chair|swivel chair|task chair|study chair|work chair|chair
armchair|easy chair|lounge chair|accent chair|reading chair|recliner|chair
dining chair|kitchen chair|chair
desk|work desk|writing desk|study desk|computer desk|writing table
side table|end table|occasional table|accent table
coffee table|cocktail table|centre table|center table
rug|carpet|area rug|mat
painting|picture|wall art|artwork|art print|framed picture|framed print|framed art
chandelier|pendant light|ceiling light|ceiling lamp|pendant|pendant lamp|ceiling light fixture|light fixture|hanging lamp
sideboard|buffet|credenza|console
plant|potted plant|houseplant|house plant|planter|indoor plant
cot|crib
piano|upright piano|grand piano
stool|bar stool|counter stool
bean bag|bean bag chair|beanbag
worktop|counter|countertop|kitchen counter|base cabinet
kitchen island|island
bench|banquette
mirror|wall mirror
cupboard|cabinet|storage cabinet
computer|monitor|laptop|computer monitor
cushion|throw pillow|pillow
)";

constexpr char kNames[] =
    "bed|bunk bed|single bed|double bed|day bed|sofa bed|table|dining table|kitchen table|sewing table|work "
    "table|workbench|"
    "console table|dressing table|vanity table|changing table|lamp|floor lamp|table lamp|desk lamp|bedside "
    "lamp|clock|wall clock|"
    "ottoman|pouf|footstool|bean bag|chest|trunk|shoe rack|coat rack|rack|hook|filing cabinet|bookend|fireplace|hearth|"
    "treadmill|exercise bike|weight bench|dumbbell rack|yoga mat|easel|drum kit|guitar|washing "
    "machine|dryer|dishwasher|"
    "shower|shower cabin|towel rail|laundry basket|ironing board|sewing machine|pantry|larder|wine rack|bar "
    "cart|trolley|"
    "toy box|toy chest|rocking chair|high chair|hammock|curtain|blind|vase|basket|bin|bucket|barrel|printer|aquarium|"
    "display case|glass cabinet|china cabinet|hutch|coffin|throne|cauldron|closet "
    "system|microwave|kettle|toaster|storage unit|"
    "radiator cover|headphones|speaker|record player|music stand|keyboard|window seat|storage box|drawer "
    "cabinet|seat|bedside lamp|"
    "wall shelf|floating shelf|picture frame|photo frame|computer table";

}  // namespace

const std::vector<std::vector<std::string>>& FurnitureSynonyms() {
  static const auto* const groups = [] {
    auto* result = new std::vector<std::vector<std::string>>;
    for (const std::string& line : std::vector<std::string>(absl::StrSplit(kSynonyms, '\n', absl::SkipEmpty()))) {
      result->push_back(absl::StrSplit(line, '|'));
    }
    return result;
  }();
  return *groups;
}

const std::vector<std::string>& FurnitureNames() {
  static const auto* const names = new std::vector<std::string>(absl::StrSplit(kNames, '|'));
  return *names;
}

std::string Singular(std::string_view word) {
  const auto ends = [&](std::string_view tail) {
    return word.size() > tail.size() + 1 && word.substr(word.size() - tail.size()) == tail;
  };
  const auto without = [&](size_t count) { return std::string(word.substr(0, word.size() - count)); };
  if (ends("shelves")) return without(3) + "f";
  if (word == "shelves") return "shelf";
  if (ends("ies") && word.size() > 4) return without(3) + "y";
  if (ends("ches") || ends("shes") || ends("xes") || ends("sses")) return without(2);
  if (ends("s") && !ends("ss") && !ends("us") && !ends("is")) return without(1);
  return std::string(word);
}

}  // namespace flair::translator
