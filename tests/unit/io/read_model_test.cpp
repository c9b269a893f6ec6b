#include "quadline/io/read_model.hpp"

#include <gtest/gtest.h>

#include <string>

#include "io/model_formats.hpp"
#include "quadline/errors.hpp"

namespace quadline {
namespace {

const std::string kSquare = "[[0, 0], [4, 0], [4, 3], [0, 3]]";

std::string message_of(const std::string& text) {
  try {
    read_model_json(text, "m.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// A model with one more key.
std::string with(const std::string& key_and_value) { return "{\"outer\": " + kSquare + ", " + key_and_value + "}"; }

Model read(const std::string& text) { return read_model_json(text, "m.json"); }

TEST(ReadModelJson, TakesAllThatAModelHolds) {
  const Model model = read(R"({"name": "plate", "about": "é 板", "units": "mm", "size": 0.5,
      "outer": [[0, 0], [4, 0], {"to": [4, 3], "via": [5, 1.5]}, [0, 3]],
      "holes": [{"center": [1, 1], "radius": 0.25}],
      "lines": [{"name": "stiffener", "path": [[2, 0], [2, 3]], "size": 0.1}, {"path": {"center": [3, 1], "radius": 1}}],
      "points": [{"name": "P", "at": [3, 2]}, {"at": [1e-3, -2E1], "size": 1}],
      "regions": [{"name": "left", "at": [1, 2], "size": 0.3}]})");
  EXPECT_EQ(model.name, "plate");
  EXPECT_EQ(model.about, "é 板");
  EXPECT_EQ(model.units, "mm");
  EXPECT_EQ(model.file, "m.json");
  EXPECT_EQ(model.size, 0.5);
  ASSERT_EQ(model.outer.size(), 1u);
  EXPECT_EQ(model.outer[0].where, "/outer");
  ASSERT_EQ(model.outer[0].items.size(), 4u);
  EXPECT_EQ(model.outer[0].items[2].to, (Point{4, 3}));
  EXPECT_EQ(model.outer[0].items[2].via, (Point{5, 1.5}));
  ASSERT_EQ(model.holes.size(), 1u);
  EXPECT_EQ(model.holes[0].where, "/holes/0");
  EXPECT_EQ(model.holes[0].circle->center, (Point{1, 1}));
  EXPECT_EQ(model.holes[0].circle->radius, 0.25);
  ASSERT_EQ(model.lines.size(), 2u);
  EXPECT_EQ(model.lines[0].name, "stiffener");
  EXPECT_EQ(model.lines[0].size, 0.1);
  EXPECT_EQ(model.lines[0].path.where, "/lines/0/path");
  EXPECT_EQ(model.lines[1].name, "");
  EXPECT_TRUE(model.lines[1].path.circle.has_value());
  EXPECT_FALSE(model.lines[1].size.has_value());
  ASSERT_EQ(model.points.size(), 2u);
  EXPECT_EQ(model.points[1].at, (Point{0.001, -20}));
  EXPECT_EQ(model.points[1].where, "/points/1");
  ASSERT_EQ(model.regions.size(), 1u);
  EXPECT_EQ(model.regions[0].name, "left");
  EXPECT_EQ(model.regions[0].size, 0.3);
  EXPECT_EQ(model.regions[0].where, "/regions/0");
}

TEST(ReadModelJson, CirclesMayAskForEdgesAndRings) {
  const Model model = read(R"({"outer": {"center": [0, 0], "radius": 9, "edges": 64},
      "holes": [{"center": [0, 0], "radius": 2, "edges": 24, "rings": 2, "ring_width": 0.5}],
      "lines": [{"path": {"center": [5, 0], "radius": 1, "rings": 1}}]})");
  EXPECT_EQ(model.outer[0].circle->edges, 64u);
  EXPECT_FALSE(model.outer[0].circle->rings || model.outer[0].circle->ring_width);
  EXPECT_EQ(model.holes[0].circle->edges, 24u);
  EXPECT_EQ(model.holes[0].circle->rings, 2u);
  EXPECT_EQ(model.holes[0].circle->ring_width, 0.5);
  EXPECT_FALSE(model.lines[0].path.circle->edges);
  EXPECT_EQ(model.lines[0].path.circle->rings, 1u);
}

TEST(ReadModelJson, TellsOneLoopFromSeveral) {
  EXPECT_EQ(read("{\"outer\": " + kSquare + "}").outer.size(), 1u);
  EXPECT_EQ(read("{\"outer\": {\"center\": [0, 0], \"radius\": 1}}").outer.size(), 1u);
  const Model two = read("{\"outer\": [" + kSquare + ", {\"center\": [9, 0], \"radius\": 1}]}");
  ASSERT_EQ(two.outer.size(), 2u);
  EXPECT_EQ(two.outer[1].where, "/outer/1");
  EXPECT_EQ(read("{\"outer\": [{\"center\": [9, 0], \"radius\": 1}, " + kSquare + "]}").outer.size(), 2u);
  EXPECT_EQ(read("{\"outer\": [" + kSquare + "]}").outer[0].where, "/outer/0");
}

TEST(ReadModelJson, NeedsOnlyAnOuterLoop) {
  const Model model = read("{\"outer\": " + kSquare + "}");
  EXPECT_EQ(model.size, 0);
  EXPECT_TRUE(model.holes.empty() && model.lines.empty() && model.points.empty() && model.regions.empty());
  EXPECT_EQ(message_of("{\"size\": 1}"), "m.json: 'outer', the loop round the domain, is missing");
}

TEST(ReadModelJson, TakesByteOrderMarksAndAnyLineEnds) {
  EXPECT_EQ(read("\xEF\xBB\xBF{\r\n\"outer\":\r" + kSquare + "\r\n}\r\n").outer.size(), 1u);
}

TEST(ReadModelJson, LeavesOtherProgramsTheirKeys) {
  EXPECT_EQ(read(with("\"$schema\": \"../model.schema.json\", \"x-colour\": {\"a\": [1, [2]]}")).outer.size(), 1u);
  EXPECT_EQ(message_of(with("\"colour\": 1")),
            "m.json: /colour: unknown key 'colour': take it out, or let it begin with 'x-'");
}

TEST(ReadModelJson, NamesTheKeyThatWasMeant) {
  EXPECT_EQ(message_of(with("\"linse\": []")), "m.json: /linse: unknown key 'linse': did you mean 'lines'?");
  EXPECT_EQ(message_of(with("\"Holes\": []")), "m.json: /Holes: unknown key 'Holes': did you mean 'holes'?");
  EXPECT_EQ(message_of(with("\"lines\": [{\"nam\": \"\", \"path\": []}]")),
            "m.json: /lines/0/nam: unknown key 'nam': did you mean 'name'?");
  EXPECT_EQ(message_of(with("\"holes\": [{\"centre\": [0, 0], \"radius\": 1}]")),
            "m.json: /holes/0/centre: unknown key 'centre': did you mean 'center'?");
  EXPECT_EQ(message_of(with("\"a/b~\": 1")),
            "m.json: /a~1b~0: unknown key 'a/b~': take it out, or let it begin with 'x-'");
}

TEST(ReadModelJson, ErrorsNameThePath) {
  EXPECT_EQ(message_of("[]"), "m.json: expected a model {...}, found an empty list");
  EXPECT_EQ(message_of(with("\"name\": 7")), "m.json: /name: expected a text \"...\", found the number 7");
  EXPECT_EQ(message_of(with("\"size\": \"4\"")), "m.json: /size: expected a number, found the text '4'");
  EXPECT_EQ(message_of(with("\"size\": true")), "m.json: /size: expected a number, found true");
  EXPECT_EQ(message_of(with("\"size\": 0")), "m.json: /size: expected a length above 0, found the number 0");
  EXPECT_EQ(message_of(with("\"size\": -2.5")), "m.json: /size: expected a length above 0, found the number -2.5");
  EXPECT_EQ(message_of(with("\"holes\": {}")), "m.json: /holes: expected a list [...], found an object {...}");
  EXPECT_EQ(message_of(with("\"lines\": [[[0, 0], [1, 1]]]")),
            "m.json: /lines/0: expected a line {...}, found a list of 2");
  EXPECT_EQ(message_of(with("\"lines\": [{\"name\": \"a\"}]")), "m.json: /lines/0: 'path' is missing");
  EXPECT_EQ(message_of(with("\"points\": [{\"name\": \"a\"}]")), "m.json: /points/0: 'at' is missing");
  EXPECT_EQ(message_of(with("\"points\": [{\"at\": [1]}]")),
            "m.json: /points/0/at: expected a point [x, y], found a list of 1");
  EXPECT_EQ(message_of(with("\"regions\": [{\"at\": [1, null]}]")),
            "m.json: /regions/0/at/1: expected a number, found nothing (null)");
  EXPECT_EQ(message_of(with("\"holes\": [{\"center\": [1, 1]}]")), "m.json: /holes/0: 'radius' is missing");
}

TEST(ReadModelJson, ErrorsOfPathsNameTheItem) {
  EXPECT_EQ(message_of(with("\"holes\": [[[0, 0], [1, 2, 3], [1, 1]]]")),
            "m.json: /holes/0/1: expected a point [x, y], found a list of 3");
  EXPECT_EQ(message_of(with("\"holes\": [[[0, 0], [1, \"x\"], [1, 1]]]")),
            "m.json: /holes/0/1/1: expected a number, found the text 'x'");
  EXPECT_EQ(message_of(with("\"holes\": [[[0, 0], {\"to\": [1, 1]}]]")), "m.json: /holes/0/1: 'via' is missing");
  EXPECT_EQ(message_of(with("\"holes\": [[{\"to\": [1, 1], \"via\": [1, 0]}, [0, 0]]]")),
            "m.json: /holes/0/0: a path starts with a point [x, y], not with an arc");
  EXPECT_EQ(message_of(with("\"lines\": [{\"path\": [[1, 1]]}]")),
            "m.json: /lines/0/path: a path needs two points or more, found a list of 1");
  EXPECT_EQ(message_of("{\"outer\": 3}"),
            "m.json: /outer: expected a path (a list of points and arcs, or a circle), found the number 3");
  EXPECT_EQ(message_of("{\"outer\": []}"), "m.json: /outer: expected a loop, or a list of loops, found an empty list");
  EXPECT_EQ(message_of("{\"outer\": [0, 0]}"), "m.json: /outer/0: expected a point [x, y], found the number 0");
  EXPECT_EQ(message_of("{\"outer\": [" + kSquare + ", 5]}"),
            "m.json: /outer/1: expected a path (a list of points and arcs, or a circle), found the number 5");
}

TEST(ReadModelJson, SyntaxErrorsNameLineAndColumn) {
  EXPECT_EQ(message_of("{\n  \"outer\": [[0, 0] [1, 0]]\n}").substr(0, 42),
            "m.json: line 2, column 20: no valid JSON: ");
  EXPECT_EQ(message_of("{\"size\": NaN}").substr(0, 41), "m.json: line 1, column 10: no valid JSON:");
  EXPECT_NE(message_of("{\"size\": 1").find("unexpected end of input"), std::string::npos);
  EXPECT_EQ(message_of(with("\"size\": 1") + "}").substr(0, 25), "m.json: line 1, column 55");
  EXPECT_EQ(message_of(""), "m.json: the file is empty");
  EXPECT_EQ(message_of(" \n\t\r\n"), "m.json: the file is empty");
}

TEST(ReadModelJson, RefusesWhatIsNotUtf8) {
  EXPECT_NE(message_of(with("\"name\": \"\xE9\"")).find("ill-formed UTF-8"), std::string::npos);
  EXPECT_EQ(message_of(std::string("\xFF\xFE{\0", 4)), "m.json: is UTF-16: save it as UTF-8");
}

TEST(ReadModelJson, RefusesNumbersBeyondADouble) {
  EXPECT_EQ(message_of(with("\"size\": 1e999")), "m.json: /size: the number 1e999 is too large");
  EXPECT_EQ(message_of(with("\"holes\": [[[0, 0], [1, -1e400]]]")),
            "m.json: /holes/0/1/1: the number -1e400 is too large");
  EXPECT_EQ(read(with("\"size\": 123456789012345678901234567890")).size, 123456789012345678901234567890.0);
}

TEST(ReadModelJson, RefusesAKeyThatStandsTwice) {
  EXPECT_EQ(message_of(with("\"size\": 1, \"size\": 2")),
            "m.json: /size: the key 'size' stands twice in this object: take one out");
  EXPECT_EQ(message_of(with("\"lines\": [{\"x-a\": [], \"path\": [[0, 0], [1, 1]], \"path\": []}]")),
            "m.json: /lines/0/path: the key 'path' stands twice in this object: take one out");
}

TEST(ReadModelJson, SurvivesDeepNesting) {
  const std::string deep(2'000'000, '[');
  EXPECT_NE(message_of(deep).find("nested more than 64 deep"), std::string::npos);
  EXPECT_NE(message_of(with("\"holes\": " + deep)).find("nested more than 64 deep"), std::string::npos);
  std::string objects;
  for (int i = 0; i < 100; ++i) objects += "{\"a\":";
  EXPECT_NE(message_of(objects).find("nested more than 64 deep"), std::string::npos);
}

TEST(ReadModelJson, EveryErrorIsOneLine) {
  EXPECT_EQ(message_of(with("\"a\\nb\": 1")).find('\n'), std::string::npos);
  EXPECT_EQ(message_of("{\"a\n").find('\n'), std::string::npos);
}

TEST(ReadModelPoly, ErrorsAreUtf8WhateverTheFileHolds) {
  try {
    read_model_poly("4 2\n\xE9\x1B[m\xC3\xA9 0 0\n", "m.poly");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "m.poly: line 2: expected the number of a vertex, found '\\xe9\\x1b[m\xC3\xA9'");
  }
}

TEST(ReadModelJson, TruncatedFilesAreErrorsEverywhere) {
  const std::string whole =
      with("\"lines\": [{\"name\": \"a\", \"path\": [[0, 1], {\"to\": [4, 1], \"via\": [2, 2]}]}]");
  for (std::size_t n = 0; n < whole.size(); ++n) EXPECT_NE(message_of(whole.substr(0, n)), "no error") << n;
  EXPECT_EQ(message_of(whole), "no error");
}

TEST(ReadModel, SaysWhyAFileCannotBeRead) {
  const auto message = [](const std::string& file) -> std::string {
    try {
      read_model(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(message("none/there.json"), "none/there.json: cannot be read: No such file or directory");
  EXPECT_EQ(message("none/there.dwg"),
            "none/there.dwg: the format '.dwg' is unknown: a model is a .json (model v1) or a .poly file");
}

}  // namespace
}  // namespace quadline
