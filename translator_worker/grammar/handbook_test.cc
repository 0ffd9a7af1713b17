// SPDX-License-Identifier: GPL-3.0-or-later
// Every sentence that the handbook's data can write is understood wholly: with every piece of furniture that may say
// it, alone and as one of two, and with every partner that it names.
#include <google/protobuf/text_format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>

#include "flair/handbook/v1/handbook.pb.h"
#include "gtest/gtest.h"
#include "translator_worker/grammar/testing/labelled_rooms.h"
#include "translator_worker/grammar/testing/scorer.h"
#include "translator_worker/grammar/translate.h"

namespace flair::translator {
namespace {

namespace hb = handbook::v1;

const std::string kRoot = FLAIR_SOURCE_DIR;

hb::Handbook ReadHandbook() {
  hb::Handbook all;
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kRoot + "/language_worker/handbook/data")) {
    if (entry.path().extension() == ".textproto") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  for (const auto& path : paths) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    hb::Handbook one;
    EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text.str(), &one)) << path;
    all.MergeFrom(one);
  }
  return all;
}

void Replace(std::string& text, const std::string& from, const std::string& to) {
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

v1::ObjectKind KindOf(const hb::Furniture& furniture) {
  switch (furniture.kind()) {
    case hb::FURNITURE_KIND_WALL:
      return v1::OBJECT_KIND_WALL;
    case hb::FURNITURE_KIND_CEILING:
      return v1::OBJECT_KIND_CEILING;
    case hb::FURNITURE_KIND_SURFACE:
      return v1::OBJECT_KIND_SURFACE;
    default:
      return v1::OBJECT_KIND_FLOOR;
  }
}

class HandbookSentences : public testing::Test {
 protected:
  HandbookSentences() : handbook_(ReadHandbook()) {
    *request_.mutable_catalog() = ReadCatalog(kRoot + "/translator_worker/grammar/testdata/catalog.textproto");
    for (const char* wall : {"south", "east", "north", "west"}) request_.mutable_room()->add_walls()->set_name(wall);
    request_.mutable_room()->add_openings()->set_kind(v1::OPENING_KIND_DOOR);
    request_.mutable_room()->add_openings()->set_kind(v1::OPENING_KIND_WINDOW);
    request_.mutable_room()->add_sockets();
    for (const hb::Furniture& furniture : handbook_.furniture()) by_name_[furniture.name()] = &furniture;
  }

  std::vector<std::string> AddObjects(const std::string& name, int count) {
    const auto found = by_name_.find(name);
    std::vector<std::string> ids;
    for (int i = 0; i < count; ++i) {
      v1::Object& object = *request_.mutable_object_list()->add_objects();
      std::string id = name + (count > 1 ? " " + std::to_string(i + 1) : "");
      std::replace(id.begin(), id.end(), ' ', '_');
      object.set_id(id);
      object.set_name(name);
      object.set_role(v1::OBJECT_ROLE_SECONDARY);
      object.set_zone_id("sleeping");
      object.set_kind(found == by_name_.end() ? v1::OBJECT_KIND_FLOOR : KindOf(*found->second));
      object.set_walk_over(found != by_name_.end() && found->second->walk_over());
      object.set_width_m(1);
      object.set_depth_m(0.5);
      ids.push_back(id);
    }
    return ids;
  }

  std::string Plural(const std::string& name) const {
    const auto found = by_name_.find(name);
    if (found != by_name_.end() && !found->second->plural().empty()) return found->second->plural();
    const std::string last = name.substr(name.size() - 1);
    if (last == "s" || last == "x" || (name.size() > 2 && (name.ends_with("ch") || name.ends_with("sh"))))
      return name + "es";
    return last == "y" ? name.substr(0, name.size() - 1) + "ies" : name + "s";
  }

  // Writes the sentence about `count` objects of the class and checks its translation.
  void Check(std::string text, const std::string& object, const std::string& target, int count,
             const std::string& further = "") {
    request_.mutable_object_list()->clear_objects();
    request_.mutable_constraint_list()->clear_sentences();
    request_.mutable_zone_plan()->clear_zones();
    v1::Zone& zone = *request_.mutable_zone_plan()->add_zones();
    zone.set_id("sleeping");
    zone.set_name("sleeping");
    const std::vector<std::string> ids = AddObjects(object, count);
    if (!target.empty()) AddObjects(target, 1);
    if (!further.empty()) AddObjects(further, 1);
    const bool together = text.find("{objects}") != std::string::npos;
    Replace(text, "{object}", count > 1 ? "second " + object : object);
    Replace(text, "{objects}", count > 1 ? Plural(object) : object);
    Replace(text, "{targets}", target);
    Replace(text, "{target}", target);
    for (const char* measure : {"{front_m}", "{sides_m}", "{back_m}", "{way_m}", "{length}"})
      Replace(text, measure, "0.9 m");
    Replace(text, "{side}", "left");
    Replace(text, "{other_side}", "right");
    Replace(text, "{room_side}", "left");
    Replace(text, "{other_room_side}", "right");
    Replace(text, "{long_side}", "back");
    Replace(text, "{corner}", "front right");
    Replace(text, "{zone}", "sleeping");
    Replace(text, "{wall}", "the north wall");
    Replace(text, "{count}", "two");
    v1::Sentence& sentence = *request_.mutable_constraint_list()->add_sentences();
    sentence.set_id("s1");
    sentence.set_text(text);
    sentence.set_weight(1);
    sentence.set_scope(v1::SENTENCE_SCOPE_INTER);
    if (together) {
      for (const std::string& id : ids) sentence.add_subject_ids(id);
    } else {
      sentence.add_subject_ids(ids.back());
    }
    const v1::LayoutGraph graph = Translate(request_);
    ++checked_;
    ASSERT_GT(graph.edges_size(), 0) << text << "\n"
                                     << graph.DebugString().substr(graph.DebugString().find("diagnostics"));
    // Of several at the sides of something each has its own.
    EXPECT_LE(graph.edges_size(), together ? count : 1) << text;
    for (const v1::Diagnostic& remark : graph.diagnostics()) ADD_FAILURE() << text << "\n" << remark.ShortDebugString();
    for (const std::string& id : together ? ids : std::vector<std::string>{ids.back()}) {
      const bool about = std::any_of(graph.edges().begin(), graph.edges().end(), [&](const v1::ConstraintEdge& edge) {
        return ToText(edge).find(id) != std::string::npos;
      });
      EXPECT_TRUE(about) << text << " says nothing of " << id << ": " << ToText(graph.edges(0));
    }
    if (examples_.insert(graph.edges(0).type()).second) std::cout << text << " -> " << ToText(graph.edges(0)) << "\n";
  }

  void CheckRelation(const hb::Relation& relation, const std::string& object) {
    std::vector<std::string> targets(relation.targets().begin(), relation.targets().end());
    if (targets.empty()) targets.push_back(relation.text().find("{target") == std::string::npos ? "" : "sideboard");
    for (const std::string& target : targets) {
      if (target == object) continue;
      for (const int count : {1, 2}) {
        if (count >= relation.condition().min_count()) Check(relation.text(), object, target, count);
      }
    }
  }

  const hb::Handbook handbook_;
  std::map<std::string, const hb::Furniture*> by_name_;
  v1::TranslateRequest request_;
  std::set<std::string> examples_;
  int checked_ = 0;
};

TEST_F(HandbookSentences, OfFurnitureAreUnderstood) {
  for (const hb::Furniture& furniture : handbook_.furniture()) {
    for (const hb::Relation& relation : furniture.relations()) CheckRelation(relation, furniture.name());
  }
  EXPECT_GT(checked_, 100);
}

TEST_F(HandbookSentences, OfRoomsThemesAndNeedsAreUnderstood) {
  for (const hb::Archetype& archetype : handbook_.archetypes()) {
    for (const hb::Relation& relation : archetype.relations()) CheckRelation(relation, relation.object());
  }
  for (const hb::Theme& theme : handbook_.themes()) {
    for (const hb::Relation& relation : theme.changes().relations()) CheckRelation(relation, relation.object());
  }
  for (const hb::Need& need : handbook_.needs()) {
    for (const hb::Relation& relation : need.changes().relations()) CheckRelation(relation, relation.object());
  }
}

TEST_F(HandbookSentences, OfGeneralRulesAreUnderstoodOfEveryPiece) {
  for (const hb::GeneralRule& rule : handbook_.general_rules()) {
    for (const hb::Furniture& furniture : handbook_.furniture()) {
      const auto& kinds = rule.selector().kinds();
      const bool floor = furniture.kind() <= hb::FURNITURE_KIND_FLOOR;
      const bool applies = kinds.empty() ? floor && !furniture.walk_over()
                                         : std::find(kinds.begin(), kinds.end(), furniture.kind()) != kinds.end();
      // What is said of all together is said of pieces that come in numbers.
      const auto& categories = rule.selector().categories();
      const bool together = rule.relation().text().find("{objects}") != std::string::npos;
      const bool named = std::ranges::find(categories, furniture.category()) != categories.end();
      if (!categories.empty() && !named) continue;
      const bool many = named || (categories.empty() && furniture.category() == "bench");
      if (applies && (!together || many)) CheckRelation(rule.relation(), furniture.name());
    }
  }
  EXPECT_GT(checked_, 500);
}

TEST_F(HandbookSentences, OfPlacesThatBriefsAskForAreUnderstood) {
  for (const hb::AskedPlace& place : handbook_.asked_places()) {
    const bool pair = place.relation().condition().min_count() == 2;
    std::vector<std::string> objects = {"desk", "sofa", "double bed", "wardrobe"};
    if (place.kinds_size() > 0) {
      const hb::FurnitureKind kind = place.kinds(0);
      objects = {kind == hb::FURNITURE_KIND_WALL      ? "painting"
                 : kind == hb::FURNITURE_KIND_CEILING ? "chandelier"
                 : kind == hb::FURNITURE_KIND_SURFACE ? "vase"
                                                      : "area rug"};
    }
    for (const std::string& object : objects) {
      std::string text = place.relation().text();
      // Of two pieces the second is there as the only one of its name as well.
      const bool between = text.find("{first}") != std::string::npos;
      Replace(text, "{first}", "armchair");
      Replace(text, "{second}", "sideboard");
      const bool named = text.find("{target}") != std::string::npos;
      // Things on one top are beside each other.
      const std::string target = place.carried() == hb::CARRIED_ALONG ? "bowl" : "armchair";
      Check(text, object, between || named ? target : "", pair ? 2 : 1, between ? "sideboard" : "");
    }
  }
  EXPECT_GT(checked_, 50);
}

TEST_F(HandbookSentences, OfEntriesWithTheirOwnSentenceAreUnderstood) {
  for (const char* target : {"bed", "sofa", "desk", "vanity"}) {
    Check("The {object} hangs on the wall opposite the {target}.", "mirror", target, 1);
  }
}

}  // namespace
}  // namespace flair::translator
