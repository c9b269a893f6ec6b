#include "base/utf8.hpp"

#include <gtest/gtest.h>

#include <string>

namespace quadline {
namespace {

TEST(Printable, LettersOfAnyScriptStay) {
  const std::string name = "Längsträger 7 \"T\" \\ \u4e2d \U0001F6A2";
  EXPECT_EQ(printable(name, '_', '?'), name);
}

TEST(Printable, WhatEndsLinesOrSteersTerminalsGoes) {
  EXPECT_EQ(printable("a\nb\x1B[2J\x7F", '_', '?'), "a_b_[2J_");
  EXPECT_EQ(printable("\u0085 \u009B \u2028\u2029 \u00A0", '_', '?'), "_ _ __ \u00A0");
}

TEST(Printable, WhatXmlDoesNotKnowGoes) { EXPECT_EQ(printable("l\uFFFE\uFFFF\uFFFD", '_', '?'), "l__\uFFFD"); }

TEST(Printable, BrokenBytesGoOneByOne) {
  EXPECT_EQ(printable("\xC3(\xFF\xED\xA0\x80", '_', '?'), "?(????");
  EXPECT_EQ(printable("\xE2\x80", '_', '?'), "??");
}

TEST(Escaped, ControlCharactersAndBrokenBytesAsCWritesThem) {
  EXPECT_EQ(escaped("a\nb\tc\r\x1B[2J\x7F"), "a\\nb\\tc\\r\\x1b[2J\\x7f");
  EXPECT_EQ(escaped("\u0085 \xC3("), "\\xc2\\x85 \\xc3(");
  EXPECT_EQ(escaped("Längsträger \"7\" \\"), "Längsträger \"7\" \\");
}

TEST(Shortened, LeavesOutTheMiddleByCharactersNotBytes) {
  EXPECT_EQ(shortened("abcdefgh", 8), "abcdefgh");
  EXPECT_EQ(shortened("abcdefghi", 8), "abcd\u2026ghi");
  EXPECT_EQ(shortened("ääääääää", 8), "ääääääää");
  EXPECT_EQ(shortened("äöüäöüäöü", 6), "äöü\u2026öü");
  EXPECT_EQ(character_count(shortened(std::string(121, 'x'), 32)), 32u);
}

}  // namespace
}  // namespace quadline
