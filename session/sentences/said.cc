// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sentences/said.h"

#include <algorithm>
#include <string_view>

#include "fmt/format.h"
#include "session/layouts/edits.h"
#include "session/sentences/answers.h"
#include "session/sentences/asides.h"
#include "session/sentences/names.h"
#include "session/sentences/places.h"

namespace flair::session {
namespace {

// What nobody asked for gives way to what the user says: twice the heaviest of a designer's sentences.
double WeightOfSaid(const v1::ConstraintList& list) {
  constexpr double kLeast = 4, kMost = 10;
  double heaviest = 0;
  for (const v1::Sentence& sentence : list.sentences()) {
    if (sentence.origin() != v1::SENTENCE_ORIGIN_BRIEF) heaviest = std::max(heaviest, sentence.weight());
  }
  return std::clamp(2 * heaviest, kLeast, kMost);
}

// How a piece stands to what it comes with.
std::string PlaceWith(const v1::Object& piece, const v1::Object& other) {
  if (piece.kind() == v1::OBJECT_KIND_SURFACE) return "The {} is on the {}.";
  if (piece.kind() == v1::OBJECT_KIND_WALL || piece.kind() == v1::OBJECT_KIND_CEILING)
    return "The {} hangs above the {}.";
  if (piece.walk_over()) return "The {} is under the {}.";
  if (piece.seat() && other.sat_at()) return "The front of the {} is next to the front of the {}.";
  return "The {} is next to the {}.";
}

class Writer {
 public:
  Writer(const Wishes& wishes, const v1::SolvedLayout& layout)
      : wishes_(wishes),
        layout_(layout),
        ids_(layout.graph().constraint_list().sentences(), kSaid),
        weight_(WeightOfSaid(layout.graph().constraint_list())) {
    for (const PieceWish& piece : wishes.pieces) {
      *said_.adds.Add()->mutable_add_object()->mutable_object() = piece.object;
    }
    said_.adds = Completed(layout, said_.adds);
    for (size_t i = 0; i < wishes.pieces.size(); ++i) {
      v1::Object& object = *said_.adds[static_cast<int>(i)].mutable_add_object()->mutable_object();
      said_.added_ids.insert(object.id());
      const int host = wishes.pieces[i].goes_with;
      if (host >= 0 && object.kind() == v1::OBJECT_KIND_SURFACE) object.set_host_id(Piece(host).id());
    }
  }

  Said Write() {
    for (size_t i = 0; i < wishes_.pieces.size(); ++i) {
      const PieceWish& piece = wishes_.pieces[i];
      if (piece.goes_with < 0) continue;
      const v1::Object &one = Piece(static_cast<int>(i)), &other = Piece(piece.goes_with);
      const std::string form = PlaceWith(one, other);
      Add(Filled(Filled(form, one.name()), other.name()), Filled(Filled(form, one.id()), other.id()), piece.said)
          .set_use(one.seat() && other.sat_at());
    }
    for (const WishedSentence& one : wishes_.sentences) {
      for (const auto& [text, piece, said, about] : WithCorners(one, layout_.graph().room())) {
        if (!about.empty()) {
          std::string name = TheOnes(layout_, about);
          if (name.starts_with("the ")) name = name.substr(4);
          said_.own_words[Add(Filled(text, name), Filled(text, Listed(about, "and")), said).id()] = said;
          continue;
        }
        const v1::Object& object = piece < 0 ? v1::Object::default_instance() : Piece(piece);
        const v1::Sentence& sentence = Add(Filled(text, object.name()), Filled(text, object.id()), said);
        if (piece < 0) said_.own_words[sentence.id()] = said;
        const std::string only_what_for = "The {} is ";
        if (piece >= 0 && text.starts_with(only_what_for) && IsPurpose(text.substr(only_what_for.size()))) {
          said_.purposes.insert(sentence.id());
        }
      }
    }
    for (int i = 0; i < said_.shown.sentences_size(); ++i) {
      v1::Sentence& meant = *said_.meant.add_sentences();
      meant = said_.shown.sentences(i);
      meant.set_text(meant_[i]);
    }
    return std::move(said_);
  }

 private:
  const v1::Object& Piece(int i) const { return said_.adds[i].add_object().object(); }

  static std::string Filled(std::string form, const std::string& name) {
    const size_t at = form.find("{}");
    return at == std::string::npos ? form : form.replace(at, 2, name);
  }

  v1::Sentence& Add(const std::string& text, const std::string& meant, const std::string& said) {
    v1::Sentence& sentence = *said_.shown.add_sentences();
    sentence.set_id(ids_.Next());
    sentence.set_text(text);
    sentence.set_scope(v1::SENTENCE_SCOPE_INTER);
    sentence.set_weight(weight_);
    sentence.set_reason(fmt::format("you said \"{}\"", said));
    sentence.set_origin(v1::SENTENCE_ORIGIN_BRIEF);
    meant_.push_back(meant);
    return sentence;
  }

  const Wishes& wishes_;
  const v1::SolvedLayout& layout_;
  FreeIds ids_;
  const double weight_;
  Said said_;
  std::vector<std::string> meant_;
};

}  // namespace

Said Written(const Wishes& wishes, const v1::SolvedLayout& layout) { return Writer(wishes, layout).Write(); }

// Why a sentence means nothing here, for people.
std::string Refusal(const v1::Sentence& sentence, const v1::LayoutGraph& understood, const Catalogue& catalogue,
                    const std::string& examples) {
  constexpr std::string_view kMissing = "the room has no \"";
  for (const v1::Diagnostic& why : understood.diagnostics()) {
    if (why.subject_id() != sentence.id()) continue;
    const size_t at = why.message().rfind(kMissing);
    if (why.code() == "names_absent_object" && at != std::string::npos) {
      const size_t begin = at + kMissing.size();
      const std::string name = why.message().substr(begin, why.message().find('"', begin) - begin);
      if (catalogue.find(name).has_value()) {
        return fmt::format(
            "\"{}\" is not understood: the room has no {}; say \"add {}\" or take one from the furniture list",
            sentence.text(), name, WithArticle(name));
      }
      return fmt::format("\"{}\" is not understood: I know no \"{}\"; the furniture list has {}", sentence.text(), name,
                         catalogue.some);
    }
    if (why.code() == "unknown_sentence") break;
    const size_t quoted = why.message().find("\": ");
    return fmt::format("\"{}\" is not understood: {}", sentence.text(),
                       quoted == std::string::npos ? why.message() : why.message().substr(quoted + 3));
  }
  return fmt::format("\"{}\" is not understood{}", sentence.text(), examples);
}

}  // namespace flair::session
