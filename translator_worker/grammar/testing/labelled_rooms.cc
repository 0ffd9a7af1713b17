// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/testing/labelled_rooms.h"

#include <fstream>
#include <map>
#include <sstream>

#include "google/protobuf/text_format.h"

namespace flair::translator {
namespace {

using nlohmann::json;

void AddFeature(const std::string& kind, v1::Room& room) {
  if (kind == "socket") {
    room.add_sockets()->set_id("socket_" + std::to_string(room.sockets_size()));
    return;
  }
  v1::Opening& opening = *room.add_openings();
  opening.set_id(kind + "_" + std::to_string(room.openings_size()));
  opening.set_kind(kind == "door" ? v1::OPENING_KIND_DOOR : v1::OPENING_KIND_WINDOW);
}

v1::Room MakeRoom(const json& line) {
  v1::Room room;
  const double w = line["width_m"];
  const double d = line["depth_m"];
  const double corners[4][2] = {{0, 0}, {w, 0}, {w, d}, {0, d}};
  for (const auto& corner : corners) {
    v1::Point2& vertex = *room.mutable_floor()->add_vertices();
    vertex.set_x_m(corner[0]);
    vertex.set_y_m(corner[1]);
  }
  for (const char* name : {"south", "east", "north", "west"}) room.add_walls()->set_name(name);
  for (const json& kind : line["features"]) AddFeature(kind, room);
  return room;
}

v1::Object MakeObject(const json& row) {
  static const std::map<std::string, v1::ObjectRole> roles = {{"primary", v1::OBJECT_ROLE_PRIMARY},
                                                              {"secondary", v1::OBJECT_ROLE_SECONDARY},
                                                              {"tertiary", v1::OBJECT_ROLE_TERTIARY}};
  static const std::map<std::string, v1::ObjectKind> kinds = {{"floor", v1::OBJECT_KIND_FLOOR},
                                                              {"wall", v1::OBJECT_KIND_WALL},
                                                              {"ceiling", v1::OBJECT_KIND_CEILING},
                                                              {"surface", v1::OBJECT_KIND_SURFACE}};
  v1::Object object;
  object.set_id(row[0]);
  object.set_name(row[1]);
  object.set_role(roles.at(row[2]));
  object.set_kind(kinds.at(row[3]));
  object.set_zone_id(row[4]);
  object.set_width_m(row[5]);
  object.set_depth_m(row[6]);
  const std::string name = row[1];
  object.set_walk_over(object.kind() == v1::OBJECT_KIND_FLOOR &&
                       (name.find("rug") != std::string::npos || name.find("carpet") != std::string::npos ||
                        (name.size() >= 3 && name.substr(name.size() - 3) == "mat")));
  return object;
}

v1::SentenceScope ScopeOf(const std::string& list) {
  if (list == "tertiary") return v1::SENTENCE_SCOPE_TERTIARY;
  return list.find("intra") != std::string::npos ? v1::SENTENCE_SCOPE_INTRA : v1::SENTENCE_SCOPE_INTER;
}

}  // namespace

std::vector<LabelledRoom> ReadLabelledRooms(const std::string& path) {
  std::vector<LabelledRoom> rooms;
  std::ifstream file(path);
  for (std::string text; std::getline(file, text);) {
    const json line = json::parse(text);
    if (line.contains("room")) {
      LabelledRoom& room = rooms.emplace_back();
      room.name = line["room"];
      room.held_out = line["held_out"];
      *room.request.mutable_room() = MakeRoom(line);
      for (const json& zone : line["zones"]) {
        v1::Zone& added = *room.request.mutable_zone_plan()->add_zones();
        added.set_id(zone);
        added.set_name(zone);
      }
      for (const json& row : line["objects"]) *room.request.mutable_object_list()->add_objects() = MakeObject(row);
      continue;
    }
    LabelledRoom& room = rooms.back();
    LabelledSentence& labelled = room.sentences.emplace_back();
    labelled.sentence.set_id("s" + std::to_string(room.sentences.size()));
    labelled.sentence.set_text(line["text"]);
    labelled.sentence.set_scope(ScopeOf(line["list"]));
    labelled.sentence.set_weight(1);
    for (const json& subject : line["subjects"]) labelled.sentence.add_subject_ids(subject);
    for (const json& part : line["parts"]) labelled.parts.push_back(part["gold"]);
  }
  return rooms;
}

v1::ConstraintCatalog ReadCatalog(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  v1::ConstraintCatalog catalog;
  google::protobuf::TextFormat::ParseFromString(text.str(), &catalog);
  return catalog;
}

}  // namespace flair::translator
