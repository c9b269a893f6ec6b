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

}  // namespace
}  // namespace quadline
