// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/object_words.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "language_worker/model/prompt_text.h"

namespace flair::language {
namespace {

bool IsIdCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

std::string Lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

}  // namespace

std::string Ordinal(size_t number) {
  constexpr std::array<const char*, 10> kOrdinals = {"first", "second",  "third",  "fourth", "fifth",
                                                     "sixth", "seventh", "eighth", "ninth",  "tenth"};
  return number < kOrdinals.size() ? kOrdinals[number] : fmt::format("{}th", number + 1);
}

ObjectWords::ObjectWords(const v1::ObjectList& objects, const v1::Room& room) {
  std::map<std::string, size_t> count, number;
  for (const v1::Object& object : objects.objects()) ++count[object.name()];
  for (const v1::Object& object : objects.objects()) {
    const size_t at = number[object.name()]++;
    words_[object.id()] = count[object.name()] > 1 ? fmt::format("{} {}", Ordinal(at), object.name()) : object.name();
  }
  for (const ObjectGroup& group : GroupObjects(objects, /*floor_only=*/false)) {
    words_.emplace(group.name, group.objects.front()->name());
  }
  for (const v1::Opening& opening : room.openings()) {
    words_.emplace(opening.id(), opening.kind() == v1::OPENING_KIND_DOOR ? "door" : "window");
  }
  for (const v1::Socket& socket : room.sockets()) words_.emplace(socket.id(), "socket");
}

std::string ObjectWords::InWords(const std::string& sentence) const {
  std::string words;
  for (size_t i = 0; i < sentence.size();) {
    if (!IsIdCharacter(sentence[i])) {
      words += sentence[i++];
      continue;
    }
    size_t end = i;
    while (end < sentence.size() && IsIdCharacter(sentence[end])) ++end;
    const std::string_view token = std::string_view(sentence).substr(i, end - i);
    // Without "_" it is a word like any other.
    const auto found = token.find('_') == std::string_view::npos ? words_.end() : words_.find(Lower(token));
    words += found == words_.end() ? token : std::string_view(found->second);
    i = end;
  }
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words;
}

}  // namespace flair::language
