// SPDX-License-Identifier: GPL-3.0-or-later
// The answers of RecordedAnswers that come from free text about all objects: style, constraints, cleaning.
#include <algorithm>
#include <map>
#include <utility>

#include "language_worker/recorded/cleaning_text.h"
#include "language_worker/recorded/prompt_ids.h"
#include "language_worker/recorded/recorded_answers.h"
#include "language_worker/recorded/style_text.h"
#include "llm/answers/utf8.h"

namespace flair::language {
namespace {

// Limits of the answers, see protos/flair/model/v1/constraint_answers.proto.
constexpr int kMostPerObject = 12, kMostPairs = 200, kMostOfAPair = 8;

// As an answer writes it.
std::string ColourText(const RecordedColour& colour) { return colour.name + " " + colour.hex; }

// The names in the prompt that mean these objects. Objects that are called alike (two bookshelves of two sizes) share
// their looks: the recorded texts tell them apart by size if at all.
std::vector<std::string> NamesFor(const std::vector<std::string>& keys, const std::vector<std::string>& names) {
  std::vector<std::string> found;
  for (const std::string& name : names) {
    if (std::find(keys.begin(), keys.end(), NameKey(name)) != keys.end()) found.push_back(name);
  }
  return found;
}

// The entry of what looks the same, as the prompt asks for.
model::v1::LookAnswer& LookLike(const model::v1::LookAnswer& made, model::v1::StyleAnswer& answer) {
  for (model::v1::LookAnswer& look : *answer.mutable_looks()) {
    if (look.material() == made.material() && look.colour() == made.colour() &&
        look.description() == made.description()) {
      return look;
    }
  }
  return *answer.add_looks() = made;
}

model::v1::ObjectSentencesAnswer& EntryFor(const std::string& name, bool must, model::v1::IntraAnswer& answer) {
  for (model::v1::ObjectSentencesAnswer& entry : *answer.mutable_objects()) {
    if (entry.object() == name && (must ? entry.must_size() : entry.should_size()) < kMostPerObject) return entry;
  }
  model::v1::ObjectSentencesAnswer& entry = *answer.add_objects();
  entry.set_object(name);
  return entry;
}

}  // namespace

std::vector<RecordedSentence> RecordedAnswers::Sentences(ConstraintTextKind kind, std::string_view ending,
                                                         Conversion& conversion) const {
  const std::string name = std::string(kind == ConstraintTextKind::kIntra ? "intra" : "inter") + std::string(ending);
  const std::string primary = "primary_" + name, secondary = "secondary_" + name;
  const auto is_primary = [&](int object) { return static_cast<size_t>(object) < primary_count_; };
  std::vector<RecordedSentence> sentences =
      ReadConstraintText({primary, room_.Text(primary), kind, floor_names_, zone_ids_}, conversion);
  // The first list is of the primaries: a secondary of the same name is not meant.
  for (RecordedSentence& sentence : sentences) {
    const std::vector<int> named = sentence.objects;
    std::erase_if(sentence.objects, [&](int object) {
      return !is_primary(object) && std::any_of(named.begin(), named.end(), [&](int other) {
        return is_primary(other) && NameOf(other) == NameOf(object);
      });
    });
  }
  for (RecordedSentence& sentence :
       ReadConstraintText({secondary, room_.Text(secondary), kind, floor_names_, zone_ids_}, conversion)) {
    // And the other way round.
    std::vector<int>& objects = sentence.objects;
    if (kind == ConstraintTextKind::kIntra && !std::all_of(objects.begin(), objects.end(), is_primary)) {
      std::erase_if(objects, is_primary);
    }
    sentences.push_back(std::move(sentence));
  }
  return sentences;
}

std::string RecordedAnswers::NameOf(int object) const { return NameKey(floor_[static_cast<size_t>(object)]->name()); }

model::v1::IntraAnswer RecordedAnswers::Intra(std::string_view prompt, Conversion& conversion) const {
  const PromptIds ids(floor_, ReadPromptObjects(prompt));
  model::v1::IntraAnswer answer;
  for (const RecordedSentence& sentence : Sentences(ConstraintTextKind::kIntra, "", conversion)) {
    const std::vector<std::string> names = ids.NamesOf(sentence.objects);
    if (names.empty()) {
      conversion.Unconvert("intra", sentence.text, "its object was left out");
      continue;
    }
    for (const std::string& name : names) {
      model::v1::ObjectSentencesAnswer& entry = EntryFor(name, sentence.must, answer);
      *(sentence.must ? entry.add_must() : entry.add_should()) = sentence.text;
    }
  }
  return answer;
}

model::v1::InterAnswer RecordedAnswers::Inter(std::string_view prompt, Conversion& conversion) const {
  const PromptIds ids(floor_, ReadPromptObjects(prompt));
  model::v1::InterAnswer answer;
  for (const RecordedSentence& sentence : Sentences(ConstraintTextKind::kInter, "", conversion)) {
    const std::vector<std::string> names = ids.NamesOf(sentence.objects);
    if (names.empty() || answer.constraints_size() == kMostPairs) {
      conversion.Unconvert("inter", sentence.text, names.empty() ? "its objects were left out" : "one too many");
      continue;
    }
    model::v1::PairAnswer entry;
    for (const std::string& name : names) {
      if (entry.objects_size() < kMostOfAPair) entry.add_objects(name);
    }
    const auto same = [&](const model::v1::PairAnswer& last) {
      return std::equal(last.objects().begin(), last.objects().end(), entry.objects().begin(), entry.objects().end()) &&
             (sentence.must ? last.must_size() : last.should_size()) < kMostPerObject;
    };
    const bool again = answer.constraints_size() > 0 && same(*answer.constraints().rbegin());
    if (!again) *answer.add_constraints() = entry;
    model::v1::PairAnswer& pair = *answer.mutable_constraints(answer.constraints_size() - 1);
    *(sentence.must ? pair.add_must() : pair.add_should()) = sentence.text;
  }
  return answer;
}

model::v1::CleaningAnswer RecordedAnswers::Cleaning(std::string_view prompt) const {
  Conversion unused;  // what counts is what was said, not what was said again
  std::vector<RecordedSentence> after = Sentences(ConstraintTextKind::kIntra, "_clean", unused);
  for (RecordedSentence& sentence : Sentences(ConstraintTextKind::kInter, "_clean", unused)) {
    after.push_back(std::move(sentence));
  }
  std::vector<std::string> names;
  for (const v1::Object* object : floor_) names.push_back(object->name());
  return FindChanges(ReadPromptSentences(prompt), after, names);
}

model::v1::StyleAnswer RecordedAnswers::Style(const std::vector<std::string>& names, Conversion& conversion) const {
  std::vector<const v1::Object*> all = floor_;
  all.insert(all.end(), tertiaries_.begin(), tertiaries_.end());
  const RecordedStyle style = ReadStyleText(room_.Text("style"), ObjectNames(all), handbook_, conversion);
  model::v1::StyleAnswer answer;
  answer.set_name("as described");
  answer.set_summary(style.summary.empty() ? llm::CutBytes(room_.brief.text(), 300) : style.summary);
  std::map<std::pair<std::string, std::string>, int> palette;
  for (const RecordedLook& look : style.looks) {
    ++palette[{look.colour.name, look.colour.hex}];
    if (look.surface == "walls" || look.surface == "floor" || look.surface == "ceiling") {
      model::v1::SurfaceAnswer& surface = *answer.add_surfaces();
      surface.set_surface(look.surface);
      surface.set_material(look.material.empty() ? "paint" : look.material);
      surface.set_colour(ColourText(look.colour));
      continue;
    }
    std::vector<std::string> keys = {NameKey(look.surface)};
    for (const int object : look.objects) keys.push_back(NameKey(all[static_cast<size_t>(object)]->name()));
    const std::vector<std::string> of = NamesFor(keys, names);
    if (of.empty()) continue;
    model::v1::LookAnswer made;
    made.set_material(look.material.empty() ? "mixed materials" : look.material);
    made.set_colour(ColourText(look.colour));
    if (!look.description.empty()) made.set_description(look.description);
    model::v1::LookAnswer& entry = LookLike(made, answer);
    for (const std::string& name : of) entry.add_of(name);
  }
  std::vector<std::pair<int, RecordedColour>> most;
  for (const auto& [colour, count] : palette) most.emplace_back(count, RecordedColour{colour.first, colour.second});
  std::stable_sort(most.begin(), most.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  constexpr size_t kPalette = 5;
  for (size_t i = 0; i < std::min(kPalette, most.size()); ++i) {
    answer.add_palette(ColourText(most[i].second));
  }
  return answer;
}

}  // namespace flair::language
