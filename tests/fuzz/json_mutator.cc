// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer's mutations of bytes, and in between some of whole JSON values: a value goes, comes twice, takes another's
// place, is wrapped or becomes a text. Models err by values, and bytes alone seldom move one whole.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t max_size);

namespace {

struct Span {
  size_t from;
  size_t size;
};

size_t StringLength(std::string_view text) {
  for (size_t i = 1; i < text.size(); ++i) {
    if (text[i] == '"') return i + 1;
    if (text[i] == '\\') ++i;
  }
  return text.size();
}

// The objects, lists, strings and words of a text; those with brackets end at their partner, of whatever kind.
std::vector<Span> ValuesOf(std::string_view text) {
  std::vector<Span> values;
  std::vector<size_t> open;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '{' || c == '[') {
      open.push_back(values.size());
      values.push_back({i, text.size() - i});
    } else if ((c == '}' || c == ']') && !open.empty()) {
      values[open.back()].size = i + 1 - values[open.back()].from;
      open.pop_back();
    } else if (std::string_view(" \t\r\n,:}]").find(c) == std::string_view::npos) {
      const std::string_view rest = text.substr(i);
      const size_t size = c == '"' ? StringLength(rest) : std::min(rest.find_first_of(" \n,:{}[]\""), rest.size());
      values.push_back({i, size});
      i += size - 1;
    }
  }
  return values;
}

std::string AsText(std::string_view value) {
  std::string text = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + '"';
}

std::string Mutated(std::string_view text, std::minstd_rand& random) {
  const std::vector<Span> values = ValuesOf(text);
  if (values.empty()) return std::string(text);
  const Span one = values[random() % values.size()], other = values[random() % values.size()];
  const std::string value(text.substr(one.from, one.size));
  const std::string before(text.substr(0, one.from)), behind(text.substr(one.from + one.size));
  switch (random() % 7) {
    case 0:
      return before + behind;
    case 1:
      return before + value + "," + value + behind;
    case 2:
      return before + std::string(text.substr(other.from, other.size)) + behind;
    case 3:
      return before + "[" + value + "]" + behind;
    case 4:
      return before + "{\"a\":" + value + "}" + behind;
    case 5:
      return before + AsText(value) + behind;
    default:
      return before + "null" + behind;
  }
}

}  // namespace

// The first byte is no text: it chooses what reads it.
extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t max_size, unsigned int seed) {
  std::minstd_rand random(seed);
  if (size < 2 || random() % 4 != 0) return LLVMFuzzerMutate(data, size, max_size);
  const std::string text = Mutated({reinterpret_cast<const char*>(data) + 1, size - 1}, random);
  if (text.size() + 1 > max_size) return LLVMFuzzerMutate(data, size, max_size);
  std::memcpy(data + 1, text.data(), text.size());
  return text.size() + 1;
}
