// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/composer.h"

#include "english/frames/noun_phrases.h"
#include "english/language.h"
#include "english/words.h"
#include "translator_worker/grammar/translate.h"

namespace flair::translator {
Composer::Composer(const v1::TranslateRequest& request, const SceneNames& names, const CatalogIndex& catalog,
                   const v1::Sentence& sentence)
    : request_(request), names_(names), catalog_(catalog), sentence_(sentence) {
  for (const std::string& subject : sentence.subject_ids()) {
    for (int i = 0; i < request.object_list().objects_size(); ++i) {
      if (object(i).id() == subject) subjects_.push_back({i, ""});
    }
  }
  // Of a heading that names several kinds of things the first is what moves.
  std::vector<Placed> others;
  for (const Placed& placed : subjects_) (IsLike(placed, subjects_.front()) ? topic_ : others).push_back(placed);
  if (sentence.scope() != v1::SENTENCE_SCOPE_INTER) return;
  // A bare distance in a sentence about two things, or two kinds of them, is kept between them.
  const bool two_kinds = !others.empty() && std::ranges::all_of(others, [&](const Placed& other) {
    return IsLike(other, others.front());
  });
  if (subjects_.size() == 2) {
    SetPair({subjects_[0]}, {subjects_[1]});
  } else if (two_kinds) {
    SetPair(topic_, others);
  }
}

bool Composer::PlacedIs(std::string_view kind, const Placed& placed) const {
  const v1::Object& it = object(placed.object);
  if (kind == "floor") return it.kind() == v1::OBJECT_KIND_FLOOR;
  if (kind == "wall") return it.kind() == v1::OBJECT_KIND_WALL;
  if (kind == "ceiling") return it.kind() == v1::OBJECT_KIND_CEILING;
  if (kind == "surface") return it.kind() == v1::OBJECT_KIND_SURFACE;
  if (kind == "primary") return it.role() == v1::OBJECT_ROLE_PRIMARY;
  if (kind == "tertiary") return it.role() == v1::OBJECT_ROLE_TERTIARY;
  if (kind == "rug") return it.walk_over();
  if (kind == "small-rug") return it.walk_over() && it.role() == v1::OBJECT_ROLE_TERTIARY;
  const auto is_placed = [&](const Call& call) {
    const bool so = kind == "on-top" ? call.arguments.size() > 1 && call.arguments[1].name() == "host"
                                     : call.type == (kind == "in-corner" ? "in_corner" : "accessible");
    return so && call.arguments.front().value().text() == it.id();
  };
  if (kind == "in-corner" || kind == "on-top") return std::ranges::any_of(calls_, is_placed);
  if (kind == "last-space") return !calls_.empty() && is_placed(calls_.back());
  if (kind == "own-chair") {
    return scope() == v1::SENTENCE_SCOPE_INTRA && subjects_.size() == 1 && subjects_.front().object != placed.object &&
           IsChair(placed) && !IsChair(subjects_.front());
  }
  const std::string_view name = english::WithoutNumber(it.name());
  const std::string last = english::Singular(name.substr(name.find_last_of(" _") + 1));
  const english::Language& language = english::Language::Get();
  // "Armchair", but not "workbench".
  return language.IsIn(kind, last) || (last.size() > 5 && last.ends_with("chair") && language.IsIn(kind, "chair"));
}

bool Composer::HasFeature(const std::string& kind) const {
  if (kind == "socket") return request_.room().sockets_size() > 0;
  const auto wanted = kind == "door" ? v1::OPENING_KIND_DOOR : v1::OPENING_KIND_WINDOW;
  return std::ranges::any_of(request_.room().openings(),
                             [&](const v1::Opening& opening) { return opening.kind() == wanted; });
}

void Composer::SetPair(std::vector<Placed> movers, std::vector<Placed> targets) {
  pair_movers_ = std::move(movers);
  pair_targets_ = std::move(targets);
}

void Composer::SetTopic(std::vector<Placed> topic) {
  if (topic.empty() || topic_.empty() || topic.front().object != topic_.front().object) earlier_topic_ = topic_;
  topic_ = std::move(topic);
}

void Composer::SpeakOf(const Mention& mention) {
  if (mention.references.front().kind != RefKind::kObjects) return;
  // What a thing on a table or wall is about is its heading: "Desk organizer: on the shelf".
  if (scope() == v1::SENTENCE_SCOPE_TERTIARY && !subjects_.empty()) return;
  std::vector<Placed> movers = Movers(&mention);
  for (Placed& placed : movers) placed.side.clear();
  if (!movers.empty()) SetTopic(std::move(movers));
}

void Composer::Refuse(std::string_view code, const std::string& message) {
  v1::Diagnostic remark = RemarkOn(sentence_, v1::SEVERITY_WARNING, code, message);
  const bool known =
      std::ranges::any_of(refusals_, [&](const v1::Diagnostic& other) { return other.message() == remark.message(); });
  if (!known) refusals_.push_back(std::move(remark));
}

bool Composer::OnlyUnknown() const {
  return std::ranges::all_of(refusals_,
                             [](const v1::Diagnostic& refusal) { return refusal.code() == "unknown_sentence"; });
}

void Composer::Note(std::string_view code, const std::string& message) {
  notes_.push_back(RemarkOn(sentence_, v1::SEVERITY_NOTE, code, message));
}

}  // namespace flair::translator
