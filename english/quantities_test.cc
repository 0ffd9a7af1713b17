// SPDX-License-Identifier: GPL-3.0-or-later
#include "english/quantities.h"

#include <string>

#include "fmt/format.h"
#include "gtest/gtest.h"

namespace flair::english {
namespace {

constexpr auto kLength = v1::Unit::KIND_LENGTH;

double Value(const std::string& text) {
  const auto number = NumberAt(Tokenize(text), 0);
  return number ? number->value : -1;
}

// Words as they are, lengths as [least..largest].
std::string Shown(const std::string& text) {
  std::string result;
  for (const Token& token : JoinLengths(KeepClauseMarks(Tokenize(text)))) {
    if (!result.empty()) result += ' ';
    if (token.kind != Token::Kind::kLength) {
      result += token.text;
      continue;
    }
    const Length& d = token.length;
    result += fmt::format("[{}..{}]", d.min_m ? fmt::format("{:.4g}", *d.min_m) : "",
                          d.max_m ? fmt::format("{:.4g}", *d.max_m) : "");
  }
  return result;
}

TEST(Numbers, AreReadInDigitsAndWords) {
  EXPECT_EQ(Value("twelve chairs"), 12);
  EXPECT_EQ(Value("a dozen chairs"), 12);
  EXPECT_EQ(Value("half a dozen"), 6);
  EXPECT_EQ(Value("twenty-five"), 25);
  EXPECT_EQ(Value("forty two"), 42);
  EXPECT_EQ(Value("a hundred"), 100);
  EXPECT_EQ(Value("two hundred"), 200);
  EXPECT_EQ(Value("one and a half"), 1.5);
  EXPECT_EQ(Value("1 1/2"), 1.5);
  EXPECT_EQ(Value("2 \u00BD"), 2.5);
  EXPECT_EQ(Value("two dozen chairs"), 24);
  EXPECT_EQ(Value("three point two five"), 3.25);
  EXPECT_EQ(Value("several"), 5);
  EXPECT_EQ(Value("a few"), 3);
  EXPECT_EQ(Value("a two-seat sofa"), 1);
  EXPECT_EQ(Value("desk"), -1);
}

double ValueOf(const std::string& text, v1::Unit::Kind kind) {
  const auto measure = MeasureAt(Tokenize(text), 0, kind);
  return measure ? measure->value : -1;
}

TEST(Measures, ComeOutInMetresDegreesAndSquareMetres) {
  EXPECT_NEAR(ValueOf("5'6\"", kLength), 1.6764, 1e-9);
  EXPECT_NEAR(ValueOf("5 ft 6 inches", kLength), 1.6764, 1e-9);
  EXPECT_NEAR(ValueOf("1 m 20 cm", kLength), 1.2, 1e-9);
  EXPECT_NEAR(ValueOf("7'-3\"", kLength), 2.2098, 1e-9);
  EXPECT_NEAR(ValueOf("8 ft 2 in the clear", kLength), 2.4892, 1e-9);
  EXPECT_NEAR(ValueOf("nine foot ten", kLength), 2.9972, 1e-9);
  EXPECT_NEAR(ValueOf("2 m 35", kLength), 2.35, 1e-9);
  EXPECT_NEAR(ValueOf("three metres ten", kLength), 3.1, 1e-9);
  EXPECT_NEAR(ValueOf("three metres ten chairs", kLength), 3, 1e-9);
  EXPECT_NEAR(ValueOf("two and a quarter metres", kLength), 2.25, 1e-9);
  EXPECT_NEAR(ValueOf("four point six metres", kLength), 4.6, 1e-9);
  EXPECT_NEAR(ValueOf("two metres wide", kLength), 2, 1e-9);
  EXPECT_NEAR(ValueOf("1\u00BD m", kLength), 1.5, 1e-9);
  EXPECT_NEAR(ValueOf("90\u00B0", v1::Unit::KIND_ANGLE), 90, 1e-9);
  EXPECT_NEAR(ValueOf("20 sq. metres", v1::Unit::KIND_AREA), 20, 1e-9);
  EXPECT_NEAR(ValueOf("20 m\u00B2", v1::Unit::KIND_AREA), 20, 1e-9);
  EXPECT_NEAR(ValueOf("215 sq ft", v1::Unit::KIND_AREA), 19.974, 1e-3);
  EXPECT_EQ(ValueOf("near", kLength), -1);
}

TEST(JoinLengths, ReadsAllTheirForms) {
  EXPECT_EQ(Shown("0.6m"), "[0.6..0.6]");
  EXPECT_EQ(Shown("60 cm"), "[0.6..0.6]");
  EXPECT_EQ(Shown("half a metre"), "[0.5..0.5]");
  EXPECT_EQ(Shown("one and a half metres"), "[1.5..1.5]");
  EXPECT_EQ(Shown("2 ft"), "[0.6096..0.6096]");
  EXPECT_EQ(Shown("at least 0.5 m"), "[0.5..]");
  EXPECT_EQ(Shown("no more than 30 cm"), "[..0.3]");
  EXPECT_EQ(Shown("0.3-1m"), "[0.3..1]");
  EXPECT_EQ(Shown("between 0.3 m and 0.5 m"), "[0.3..0.5]");
  EXPECT_EQ(Shown("a minimum distance of 0.5m"), "a distance of [0.5..]");
  EXPECT_EQ(Shown("1 m or more"), "[1..]");
  EXPECT_EQ(Shown("pushed up to a wall"), "pushed up to a wall");
}

TEST(JoinLengths, DropsSizesWhichPlaceNothing) {
  EXPECT_EQ(Shown("rug 1.8m x 2.8m here"), "rug here");
  EXPECT_EQ(Shown("0.6m wide, 0.1m long"), ",");
  EXPECT_EQ(Shown("the 2.5m side"), "the length:2.500");
}

}  // namespace
}  // namespace flair::english
