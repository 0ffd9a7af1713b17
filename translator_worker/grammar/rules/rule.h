// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "translator_worker/grammar/composer.h"
#include "translator_worker/grammar/pattern.h"

namespace flair::translator {

// Makes the calls of one fact. `tag` is the rule's own, for builders that serve several patterns.
using Builder = void (*)(const Match& match, std::string_view tag, Composer& composer);

// A row of a family's table: the form of a fact and what it means.
struct Rule {
  std::string_view pattern;
  Builder build;
  std::string_view tag = "";
};

// One table per family, each in the file of its name.
std::vector<Rule> AccessRules();
std::vector<Rule> AngleRules();
std::vector<Rule> DistanceRules();
std::vector<Rule> FeatureRules();
std::vector<Rule> FeatureNearRules();
std::vector<Rule> FrontRules();
std::vector<Rule> GroupRules();
std::vector<Rule> HangingRules();
std::vector<Rule> InFrontRules();
std::vector<Rule> NearRules();
std::vector<Rule> PathRules();
std::vector<Rule> PullOutRules();
std::vector<Rule> RoomRules();
std::vector<Rule> SpaceRules();
std::vector<Rule> SurfaceRules();
std::vector<Rule> WalkwayRules();
std::vector<Rule> WallRules();

}  // namespace flair::translator
