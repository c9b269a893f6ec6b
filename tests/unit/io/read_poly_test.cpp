#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "io/model_formats.hpp"
#include "quadline/errors.hpp"

namespace quadline {
namespace {

Model read(const std::string& text) { return read_model_poly(text, "p.poly"); }

std::string message_of(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

double area_of(const Path& path) {
  double twice = 0;
  for (std::size_t i = 0; i < path.items.size(); ++i)
    twice += cross(path.items[i].to, path.items[(i + 1) % path.items.size()].to);
  return 0.5 * twice;
}

/// What is left of the loops: outer areas less holes. Outer loops run counter-clockwise, holes clockwise.
double area_of(const Model& model) {
  double area = 0;
  for (const Path& path : model.outer) area += area_of(path);
  for (const Path& path : model.holes) area += area_of(path);
  return area;
}

const std::string kSquare = "4 2 0 0\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n";

TEST(ReadModelPoly, ReadsASquare) {
  const Model model = read(kSquare + "0\n");
  EXPECT_EQ(model.name, "p");
  EXPECT_EQ(model.file, "p.poly");
  EXPECT_EQ(model.size, 0);
  ASSERT_EQ(model.outer.size(), 1u);
  EXPECT_EQ(model.outer[0].where, "line 7");
  ASSERT_EQ(model.outer[0].items.size(), 4u);
  EXPECT_EQ(area_of(model.outer[0]), 12);
  EXPECT_TRUE(model.holes.empty() && model.lines.empty() && model.points.empty() && model.regions.empty());
}

TEST(ReadModelPoly, TakesCommentsBlankLinesAttributesAndNumbersFromZero) {
  const Model model = read(
      "# a square\n\n 4 2 1 1 # head\r\n0 0 0 7.5 1\n\n1\t4 0 7.5 1\n2 4e0 3 0 1\n # inside\n3 0 +3 0 1\n"
      "4 1\n0 0 1 1\n1 1 2 1 # side\n2 2 3 1\n3 3 0 1\n0\n\n# end");
  ASSERT_EQ(model.outer.size(), 1u);
  EXPECT_EQ(area_of(model.outer[0]), 12);
  EXPECT_EQ(model.outer[0].where, "line 11");
}

TEST(ReadModelPoly, FindsHolesAndIslandsByThePointsInHoles) {
  // Squares of edge 10, 6, 4 and 2 in each other: the second is a hole, the third an island in it, the last a line.
  std::string vertices = "16 2 0 0\n", segments = "16 0\n";
  int n = 0;
  for (const int half : {5, 3, 2, 1}) {
    const int corners[4][2] = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
    for (int i = 0; i < 4; ++i) {
      vertices +=
          std::to_string(n + i + 1) + ' ' + std::to_string(corners[i][0]) + ' ' + std::to_string(corners[i][1]) + '\n';
      segments += std::to_string(n + i + 1) + ' ' + std::to_string(n + i + 1) + ' ' +
                  std::to_string(n + (i + 1) % 4 + 1) + '\n';
    }
    n += 4;
  }
  const Model model = read(vertices + segments + "1\n1 2.5 0\n");
  EXPECT_EQ(model.outer.size(), 2u);
  EXPECT_EQ(model.holes.size(), 1u);
  EXPECT_EQ(area_of(model), 100 - 36 + 16);
  ASSERT_EQ(model.lines.size(), 1u);
  EXPECT_EQ(model.lines[0].path.items.size(), 5u);
  EXPECT_EQ(model.lines[0].path.items.front().to, model.lines[0].path.items.back().to);
  EXPECT_EQ(area_of(read(vertices + segments + "2\n1 2.5 0\n2 0.5 0.5\n")), 100 - 36 + 16 - 4);
  EXPECT_EQ(area_of(read(vertices + segments + "1\n1 7 7\n")), 100);  // a point outside all asks for nothing
}

TEST(ReadModelPoly, MakesLinesOfTheOtherSegments) {
  // Inside a square of edge 10: a bent line of marker 7, a branch in it, one without a marker.
  const Model model = read(
      "11 2 0 0\n1 0 0\n2 10 0\n3 10 10\n4 0 10\n5 2 2\n6 5 5\n7 8 5\n8 5 8\n9 0 5\n10 1 8\n11 2 9\n"
      "10 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 9 1\n5 9 1 1\n6 5 6 7\n7 6 7 7\n8 8 6 7\n9 5 9 3\n10 10 11 0\n0\n");
  ASSERT_EQ(model.lines.size(), 5u);
  EXPECT_EQ(model.lines[0].name, "line-7-1");
  EXPECT_EQ(model.lines[0].path.where, "line 19");
  EXPECT_EQ(model.lines[1].name, "line-7-2");
  EXPECT_EQ(model.lines[2].name, "line-7-3");
  EXPECT_EQ(model.lines[3].name, "line-3");
  EXPECT_EQ(model.lines[4].name, "segment-10");
  EXPECT_EQ(model.outer[0].items.size(), 5u);
}

TEST(ReadModelPoly, JoinsSegmentsOfOneMarkerToALine) {
  const Model model = read(
      "8 2 0 0\n1 0 0\n2 10 0\n3 10 10\n4 0 10\n5 2 2\n6 5 5\n7 8 5\n8 8 8\n"
      "7 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n5 7 8 2\n6 6 5 2\n7 6 7 2\n0\n");
  ASSERT_EQ(model.lines.size(), 1u);
  EXPECT_EQ(model.lines[0].name, "line-2");
  ASSERT_EQ(model.lines[0].path.items.size(), 4u);
}

TEST(ReadModelPoly, SplitsSegmentsWhereTheyCross) {
  const Model model = read(
      "8 2 0 0\n0 0 0\n1 10 0\n2 10 10\n3 0 10\n4 -1 5\n5 11 5\n6 5 0\n7 5 10\n"
      "6 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n4 4 5\n5 6 7\n0\n");
  ASSERT_EQ(model.outer.size(), 1u);
  EXPECT_EQ(model.outer[0].items.size(), 8u);
  EXPECT_EQ(area_of(model), 100);
  EXPECT_EQ(model.lines.size(), 6u);  // four arms of the cross inside, and two ends outside
}

TEST(ReadModelPoly, TakesABoundaryThatMeetsToRounding) {
  // The last side ends 1e-10 beside the first vertex; a line ends as near to a side.
  const Model model = read(
      "7 2 0 0\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n5 0 1e-10\n6 2 1e-10\n7 2 2\n"
      "5 0\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n5 6 7\n0\n");
  ASSERT_EQ(model.outer.size(), 1u);
  EXPECT_NEAR(area_of(model), 12, 1e-8);
  EXPECT_EQ(model.outer[0].items.size(), 5u);
  ASSERT_EQ(model.lines.size(), 1u);
}

TEST(ReadModelPoly, TakesLoopsThatTouchApart) {
  // Two squares that share a corner; in the first a hole that touches its side at a corner.
  const Model model = read(
      "11 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 8 4\n6 8 8\n7 4 8\n8 2 0\n9 3 1\n10 2 2\n11 1 1\n"
      "13 0\n1 1 8\n2 8 2\n3 2 3\n4 3 4\n5 4 1\n6 3 5\n7 5 6\n8 6 7\n9 7 3\n10 8 9\n11 9 10\n12 10 11\n13 11 8\n"
      "1\n1 2 1\n");
  EXPECT_EQ(model.outer.size(), 2u);
  EXPECT_EQ(model.holes.size(), 1u);
  EXPECT_EQ(area_of(model), 16 - 2 + 16);
}

TEST(ReadModelPoly, KeepsVerticesWithoutSegments) {
  const Model model = read("5 2 0 0\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n5 1 2\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  ASSERT_EQ(model.points.size(), 1u);
  EXPECT_EQ(model.points[0].name, "vertex-5");
  EXPECT_EQ(model.points[0].at, (Point{1, 2}));
  EXPECT_EQ(model.points[0].where, "line 6");
}

TEST(ReadModelPoly, ReadsRegionsWithTheirAreas) {
  const Model model = read(kSquare + "0\n3\n1 1 1 3 0.5\n2 2 2 -1.5 -1\n3 3 2 4\n");
  ASSERT_EQ(model.regions.size(), 3u);
  EXPECT_EQ(model.regions[0].name, "region-3");
  EXPECT_DOUBLE_EQ(std::sqrt(3.0) / 4 * *model.regions[0].size * *model.regions[0].size, 0.5);
  EXPECT_EQ(model.regions[0].where, "line 13");
  EXPECT_EQ(model.regions[1].name, "region--1.5");
  EXPECT_FALSE(model.regions[1].size.has_value());
  EXPECT_FALSE(model.regions[2].size.has_value());
}

TEST(ReadModelPoly, ReadsVerticesFromANodeFileBesideIt) {
  std::string name = (std::filesystem::temp_directory_path() / "quadline-test-XXXXXX").string();
  const std::filesystem::path folder = mkdtemp(name.data());
  std::ofstream(folder / "p.node") << "5 2 0 0\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n5 1 1\n";
  const std::string text = "0 2 0 0\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n";
  const Model model = read_model_poly(text, folder / "p.poly");
  EXPECT_EQ(area_of(model), 12);
  ASSERT_EQ(model.points.size(), 1u);
  EXPECT_EQ(model.points[0].where, "line 6 of " + (folder / "p.node").string());
  std::filesystem::remove_all(folder);
  EXPECT_NE(message_of(text).find("p.node: cannot be read"), std::string::npos);
}

TEST(ReadModelPoly, ErrorsNameTheLine) {
  EXPECT_EQ(message_of(""), "p.poly: expected the number of vertices, found the end of the file");
  EXPECT_EQ(message_of("3 2 0 0\n1 0 0\n"), "p.poly: line 2: expected vertex 2 of 3, found the end of the file");
  EXPECT_EQ(message_of("1 3 0 0\n1 0 0 0\n"), "p.poly: line 1: the dimension must be 2");
  EXPECT_EQ(message_of("-1 2 0 0\n"), "p.poly: line 1: the number of vertices is negative");
  EXPECT_EQ(message_of("1 2\n1 0 x\n"), "p.poly: line 2: expected the y coordinate, found 'x'");
  EXPECT_EQ(message_of("1 2\n1 0\n"), "p.poly: line 2: expected the y coordinate, found the end of the line");
  EXPECT_EQ(message_of("1 2\n1 0 nan\n"), "p.poly: line 2: the y coordinate is not a finite number");
  EXPECT_EQ(message_of("2 2\n1 0 0\n3 0 0\n"),
            "p.poly: line 3: vertices must be numbered without gaps: expected vertex 2");
  EXPECT_EQ(message_of("1 2\n1 0 0\n1 0\n1 1 9\n"), "p.poly: line 4: there is no vertex 9: they go from 1 to 1");
  EXPECT_EQ(message_of("99999999999 2\n"), "p.poly: line 1: too many vertices");
  EXPECT_EQ(message_of(kSquare), "p.poly: line 10: expected the number of holes, found the end of the file");
  EXPECT_EQ(message_of(kSquare + "0\n1\n1 0 0\n"),
            "p.poly: line 13: expected the attribute of a region, found the end of the line");
  EXPECT_EQ(message_of(kSquare + "0\n0\n5 5\n"), "p.poly: line 13: expected the end of the file after 0 regions");
}

TEST(ReadModelPoly, RefusesWhatEnclosesNothing) {
  const std::string nothing = "the segments close no loop that is not a hole: nothing is left to mesh";
  EXPECT_EQ(message_of(kSquare + "1\n1 1 1\n"), "p.poly: " + nothing);
  EXPECT_EQ(message_of("2 2\n1 0 0\n2 1 1\n1 0\n1 1 2\n0\n"), "p.poly: " + nothing);
  EXPECT_EQ(message_of("1 2\n1 0 0\n0 0\n0\n"), "p.poly: " + nothing);
}

}  // namespace
}  // namespace quadline
