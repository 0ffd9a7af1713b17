// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/layouts/sizing.h"

#include <algorithm>
#include <cmath>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "english/language.h"
#include "fmt/format.h"

namespace flair::session {
namespace {

constexpr double kUsualChange = 1.2, kLeastSize_m = 0.01;

// Sides of a piece that a change is about.
struct Sides {
  bool width = false, depth = false, height = false;
};

// Tables and rugs are as long as their longer side, and wide as the other one.
bool HasLongSide(const v1::Object& object) {
  const std::string low = absl::AsciiStrToLower(object.name());
  return english::Language::Get().IsIn("pieces with long sides", low.substr(low.rfind(' ') + 1));
}

Sides SidesOf(const v1::Object& object, const std::string& dimension) {
  const bool long_width = object.width_m() >= object.depth_m();
  Sides sides;
  if (dimension == "high") {
    sides.height = true;
  } else if (dimension == "big" || object.round()) {
    sides.width = sides.depth = true;
  } else if (dimension == "long") {
    (long_width ? sides.width : sides.depth) = true;
  } else if (dimension == "wide") {
    (long_width && HasLongSide(object) ? sides.depth : sides.width) = true;
  } else {
    sides.depth = true;
  }
  return sides;
}

// To 5 cm where it is large enough.
double Rounded(double size_m) {
  constexpr double kStep_m = 0.05, kFineStep_m = 0.01, kLarge_m = 0.5;
  const double step_m = size_m < kLarge_m ? kFineStep_m : kStep_m;
  return std::max(kLeastSize_m, std::round(size_m / step_m) * step_m);
}

class Sizer {
 public:
  explicit Sizer(const v1::Object& object) : object_(object) { size_.set_object_id(object.id()); }

  template <typename Change>
  void Apply(const Sides& sides, const Change& change) {
    if (sides.width) size_.set_width_m(change(object_.width_m()));
    if (sides.depth) size_.set_depth_m(change(object_.depth_m()));
    if (sides.height) size_.set_height_m(change(object_.height_m()));
  }

  v1::ResizeObject Changed() {
    constexpr double kSame_m = 1e-6;
    const auto same = [](double a, double b) { return std::abs(a - b) < kSame_m; };
    if (same(size_.width_m(), object_.width_m())) size_.clear_width_m();
    if (same(size_.depth_m(), object_.depth_m())) size_.clear_depth_m();
    if (same(size_.height_m(), object_.height_m())) size_.clear_height_m();
    return size_;
  }

  v1::ResizeObject& size() { return size_; }

 private:
  const v1::Object& object_;
  v1::ResizeObject size_;
};

// "More long" is a factor above 1.
double FactorOf(const Spoken& spoken, const std::string& change, double share) {
  const double full = spoken.factor > 0 ? spoken.factor : kUsualChange;
  const double factor = 1 + (full - 1) * share;
  return change.starts_with("less") ? 1 / factor : factor;
}

void ResizeTo(const v1::Object& object, const Spoken& spoken, Sizer& sizer) {
  if (spoken.size_m.empty()) {
    const double length_m = spoken.length_m.value_or(0);
    sizer.Apply(SidesOf(object, spoken.dimension.empty() ? "long" : spoken.dimension),
                [&](double) { return length_m; });
    return;
  }
  // The larger figure is for the longer side, whichever was said first.
  const auto [less, more] = std::minmax(spoken.size_m[0], spoken.size_m[1]);
  const bool long_width = object.width_m() >= object.depth_m();
  sizer.size().set_width_m(long_width ? more : less);
  sizer.size().set_depth_m(long_width ? less : more);
  if (spoken.size_m.size() > 2) sizer.size().set_height_m(spoken.size_m[2]);
}

}  // namespace

v1::ResizeObject SizeAfter(const v1::Object& object, const Spoken& spoken, double share) {
  Sizer sizer(object);
  std::vector<std::string> changes = spoken.changes;
  const std::string of_act = spoken.act.substr(std::min(spoken.act.size(), std::string("resize ").size()));
  if (of_act.starts_with("more ") || of_act.starts_with("less ")) changes = {of_act};
  if (of_act == "to") {
    ResizeTo(object, spoken, sizer);
  } else if (of_act == "double" || of_act == "half") {
    const double factor = of_act == "half" ? M_SQRT1_2 : M_SQRT2;
    sizer.Apply(SidesOf(object, "big"), [&](double size_m) { return Rounded(size_m * factor); });
  } else if (changes.empty()) {
    // "Twice as long"; what is twice as big has twice the floor. "Not long enough" has no figure.
    double factor = spoken.factor > 0 ? spoken.factor : 1 + (kUsualChange - 1) * share;
    if (spoken.dimension == "big" && spoken.factor > 0) factor = std::sqrt(factor);
    sizer.Apply(SidesOf(object, spoken.dimension), [&](double size_m) { return Rounded(size_m * factor); });
  }
  for (const std::string& change : changes) {
    const Sides sides = SidesOf(object, change.substr(change.find(' ') + 1));
    if (spoken.length_m.has_value()) {
      const double by_m = change.starts_with("less") ? -*spoken.length_m : *spoken.length_m;
      sizer.Apply(sides, [&](double size_m) { return std::max(kLeastSize_m, size_m + by_m); });
    } else {
      const double factor = FactorOf(spoken, change, share);
      sizer.Apply(sides, [&](double size_m) { return Rounded(size_m * factor); });
    }
  }
  return sizer.Changed();
}

std::string SizeChange(const v1::Object& before, v1::ResizeObject size, const Spoken& spoken) {
  // Who said both figures hears both.
  if (!spoken.size_m.empty()) {
    if (!size.has_width_m()) size.set_width_m(before.width_m());
    if (!size.has_depth_m()) size.set_depth_m(before.depth_m());
  }
  if (size.has_width_m() && size.has_depth_m()) {
    std::string text = fmt::format("{:.2f} m x {:.2f} m", size.width_m(), size.depth_m());
    if (size.has_height_m()) text += fmt::format(" and {:.2f} m high", size.height_m());
    return fmt::format("{} now (was {:.2f} m x {:.2f} m)", text, before.width_m(), before.depth_m());
  }
  const bool long_width = before.width_m() >= before.depth_m();
  const auto one = [](double is_m, const char* word, double was_m) {
    return fmt::format("{:.2f} m {} now (was {:.2f} m)", is_m, word, was_m);
  };
  std::vector<std::string> texts;
  if (size.has_width_m()) {
    texts.push_back(one(size.width_m(), long_width && HasLongSide(before) ? "long" : "wide", before.width_m()));
  }
  if (size.has_depth_m()) {
    const char* const word = !long_width ? "long" : HasLongSide(before) ? "wide" : "deep";
    texts.push_back(one(size.depth_m(), word, before.depth_m()));
  }
  if (size.has_height_m()) texts.push_back(one(size.height_m(), "high", before.height_m()));
  return fmt::format("{}", fmt::join(texts, " and "));
}

}  // namespace flair::session
