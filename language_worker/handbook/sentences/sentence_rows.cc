// SPDX-License-Identifier: GPL-3.0-or-later
// How the program's lines stand: in rows, in islands, at a table; and what is said of neighbours.
#include <algorithm>

#include "language_worker/handbook/sentences/fill.h"
#include "language_worker/handbook/sentences/sentence_writer.h"

namespace flair::language {

const ProgramItem* SentenceWriter::LineOf(const v1::Object& object) const {
  const auto line = std::ranges::find_if(program_.floor_items, [&](const ProgramItem& item) {
    return item.furniture->name() == object.name() && item.zone == ZoneName(object);
  });
  return line == program_.floor_items.end() ? nullptr : &*line;
}

bool SentenceWriter::HasWays(const Group& group) const {
  const ProgramItem* line = LineOf(*group.front());
  return line != nullptr && line->abreast > 0 && group.size() > static_cast<std::size_t>(line->abreast);
}

bool SentenceWriter::StandsInRows(const Group& group) const {
  const ProgramItem* line = LineOf(*group.front());
  return line != nullptr && line->behind_each_other;
}

bool SentenceWriter::StandsInOwnRows(const Group& group) const {
  const ProgramItem* line = LineOf(*group.front());
  return line != nullptr && line->own_rows;
}

bool SentenceWriter::IsSeated(const Group& group) const {
  const ProgramItem* line = LineOf(*group.front());
  return line != nullptr && line->seat_of != nullptr;
}

bool SentenceWriter::IsTogether(const Group& group) const {
  const ProgramItem* line = LineOf(*group.front());
  return line != nullptr && line->in_each > 1 && group.size() > 1;
}

// Two by two: an island has every second one at the back of the one before, and the next pair at its right. In a row
// each has the one before at its left; where as many stand as nobody climbs over, the next follow beyond a way, which a
// relation without a side tells.
std::vector<v1::Sentence> SentenceWriter::WriteNeighbours(const hb::Relation& relation, const Group& group) const {
  const ProgramItem* line = LineOf(*group.front());
  const bool island = IsTogether(group) && !line->in_rows;
  const std::size_t abreast =
      island || line == nullptr || line->abreast == 0 ? group.size() : static_cast<std::size_t>(line->abreast);
  const bool sideless = relation.text().find("{side}") == std::string::npos;
  const bool beyond = sideless && abreast < group.size();
  std::vector<v1::Sentence> sentences;
  const bool of_ways = relation.text().find("{objects}") != std::string::npos;
  if ((island && sideless) || (of_ways && !beyond)) return sentences;
  for (std::size_t i = 1; i < group.size(); ++i) {
    if ((i % abreast == 0) != beyond) continue;
    if (beyond) {
      sentences.push_back(WriteOne(relation, {group[i - 1], group[i]}, {}, i));
      continue;
    }
    hb::Relation sided = relation;
    const bool behind = island && i % 2 == 1;
    sided.set_text(
        Fill(relation.text(), {{"side", behind ? "back" : "left"}, {"other_side", behind ? "back" : "right"}}));
    sentences.push_back(WriteOne(sided, {group[i]}, {group[island && !behind ? i - 2 : i - 1]}, i));
  }
  return sentences;
}

// The objects of the same name in the nearest zone before that of `object` which has some.
Group SentenceWriter::RowBefore(const v1::Object& object) const {
  Group row;
  for (const v1::Zone& zone : zones_.zones()) {
    if (zone.id() == object.zone_id()) break;
    Group here;
    for (const v1::Object* other : groups_.at(object.name())) {
      if (other->zone_id() == zone.id()) here.push_back(other);
    }
    if (!here.empty()) row = here;
  }
  return row;
}

}  // namespace flair::language
