// SPDX-License-Identifier: GPL-3.0-or-later
// Which pieces are meant, and their names in messages.
#include <algorithm>
#include <string_view>

#include "absl/strings/ascii.h"
#include "room/conversion/conversion.h"
#include "session/sentences/names.h"

namespace flair::session {
namespace {

bool IsOfWord(char c) { return absl::ascii_isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Whether the text speaks of one of these in the singular: by its name, or by the last word of it.
bool SpeaksOf(const std::string& text, const v1::Object& object) {
  const std::string low = absl::AsciiStrToLower(text), name = absl::AsciiStrToLower(object.name());
  return !name.empty() && FindWord(low, name.substr(name.rfind(' ') + 1)) != std::string::npos;
}

bool AreAlike(const v1::Object& a, const v1::Object& b) {
  return a.name() == b.name() || (!a.category().empty() && a.category() == b.category());
}

}  // namespace

size_t FindWord(std::string_view text, std::string_view word, size_t from) {
  for (size_t at = text.find(word, from); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const size_t end = at + word.size();
    if ((at == 0 || !IsOfWord(text[at - 1])) && (end == text.size() || !IsOfWord(text[end]))) return at;
  }
  return std::string_view::npos;
}

v1::ObjectList MeantBy(const std::string& text, const v1::SolvedLayout& layout, const IdSet& selected) {
  const auto& objects = layout.graph().object_list().objects();
  const IdSet placed = IdsOf(layout.placements());
  const auto is_meant = [&](const v1::Object& object) {
    if (!placed.contains(object.id())) {
      return std::ranges::none_of(objects, [&](const v1::Object& other) {
        return placed.contains(other.id()) && other.name() == object.name();
      });
    }
    return selected.contains(object.id()) || std::ranges::none_of(objects, [&](const v1::Object& other) {
             return selected.contains(other.id()) && AreAlike(object, other) && SpeaksOf(text, other);
           });
  };
  v1::ObjectList meant;
  for (const v1::Object& object : objects) {
    if (is_meant(object)) *meant.add_objects() = object;
  }
  const IdSet ids = IdsOf(meant.objects());
  for (v1::Object& object : *meant.mutable_objects()) {
    if (!ids.contains(object.host_id())) object.clear_host_id();
  }
  return meant;
}

v1::StyleSheet LooksOf(const v1::ObjectList& objects, const v1::SolvedLayout& layout) {
  IdSet others = IdsOf(layout.graph().object_list().objects());
  for (const v1::Object& object : objects.objects()) others.erase(object.id());
  v1::StyleSheet looks = layout.graph().style_sheet();
  EraseIf(*looks.mutable_objects(), [&](const auto& style) { return others.contains(style.subject_id()); });
  return looks;
}

void LookLike(const std::string& like_id, const std::string& id, v1::LayoutGraph& graph) {
  auto& styles = *graph.mutable_style_sheet()->mutable_objects();
  const auto like = std::ranges::find(styles, like_id, &v1::ObjectStyle::subject_id);
  if (like_id == id || like == styles.end()) return;
  v1::ObjectStyle style = *like;
  style.set_subject_id(id);
  EraseIf(styles, [&](const v1::ObjectStyle& one) { return one.subject_id() == id; });
  *styles.Add() = std::move(style);
}

std::string WithNames(const std::string& message, const v1::SolvedLayout& layout) {
  const absl::StatusOr<Scene> scene = SceneFromProto(layout.graph());
  std::string named = message;
  if (!scene.ok()) return named;
  for (int i = 0; i < static_cast<int>(scene->objects.size()); ++i) {
    const std::string& id = scene->objects[i].id;
    std::string name = NameForPeople(*scene, i);
    // What a user wrote stays, and so does what is no id: "desk".
    if (id.find('_') == std::string::npos) continue;
    for (size_t at = named.find('"' + id + '"'); at != std::string::npos; at = named.find('"' + id + '"', at)) {
      named.replace(at, id.size() + 2, name);
    }
    for (size_t at = FindWord(named, id); at != std::string::npos; at = FindWord(named, id, at + name.size())) {
      const std::string article = "the ";
      if (at >= article.size() && absl::AsciiStrToLower(named.substr(at - article.size(), article.size())) == article &&
          name.starts_with(article)) {
        name = name.substr(article.size());
      }
      named.replace(at, id.size(), name);
    }
  }
  return named;
}

}  // namespace flair::session
