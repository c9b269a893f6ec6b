#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "quadline/inspect.hpp"

namespace quadline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Model plate() {
  Model model;
  model.size = 1;
  model.outer = {{.items = {{{0, 0}}, {{4, 0}}, {{4, 3}}, {{0, 3}}}}};
  return model;
}

Options with(void (*set)(Options&, double), double value) {
  Options options;
  set(options, value);
  return options;
}

/// What `run` throws: its code and its text; nothing where it does not.
template <class Run>
std::string refusal(Run run) {
  try {
    run();
  } catch (const InputError& error) {
    return std::string(name_of(error.code())) + ": " + error.what();
  }
  return "";
}

struct Case {
  const char* option;
  void (*set)(Options&, double);
  std::string expected;
  std::vector<double> bad, good;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"size", [](Options& o, double x) { o.size = x; }, "a number above 0", {0, -1}, {0.5, 1e300}},
      {"tolerance", [](Options& o, double x) { o.tolerance = x; }, "a number above 0", {0, -1}, {1e-6}},
      {"growth",
       [](Options& o, double x) { o.growth = x; },
       "a number above 1 and up to 1e+06",
       {0, -1, 0.5, 1, 1.1e6, 1e300},
       {1.01, 1e6}},
      {"edges_per_circle",
       [](Options& o, double x) { o.edges_per_circle = x; },
       "a number from 4 to 10000",
       {0, -5, 3.9, 1e9},
       {4, 1e4}},
      {"max_quads",
       [](Options& o, double x) { o.max_quads = x; },
       "a number from 1 to 1e+09",
       {0, -1, 0.5, 1e300},
       {1, 1e9}},
      {"criteria.max_aspect",
       [](Options& o, double x) { o.criteria.emplace().max_aspect = x; },
       "a number of 1 or more",
       {0, -3, 0.9},
       {1, 5}},
      {"criteria.min_angle_deg",
       [](Options& o, double x) { o.criteria.emplace().min_angle_deg = x; },
       "a number from 0 to 360",
       {-1, 361},
       {0, 360}},
      {"criteria.min_scaled_jacobian",
       [](Options& o, double x) { o.criteria.emplace().min_scaled_jacobian = x; },
       "a number from -1 to 1",
       {-1.1, 1.1},
       {-1, 1}}};
  return all;
}

TEST(CheckOptions, RefusesEachNumberThatMakesNoSenseByName) {
  for (const Case& c : cases()) {
    std::vector<double> bad = c.bad;
    bad.insert(bad.end(), {kNan, kInfinity, -kInfinity});
    for (const double value : bad) {
      const std::string text = refusal([&] { check(with(c.set, value)); });
      EXPECT_EQ(text.find(std::string("InvalidOption: Options::") + c.option + " is "), 0u) << value << ": " << text;
      EXPECT_NE(text.find(": expected " + c.expected), text.npos) << value << ": " << text;
    }
    for (const double value : c.good) EXPECT_EQ(refusal([&] { check(with(c.set, value)); }), "") << c.option;
  }
  EXPECT_EQ(refusal([] { check({}); }), "");
}

TEST(CheckOptions, EveryLimitOfTheCriteriaIsLookedAt) {
  for (const CriteriaField& field : criteria_fields()) {
    Options options;
    options.criteria.emplace().*field.limit = kNan;
    const std::string name = "criteria." + std::string(field.name);
    EXPECT_NE(refusal([&] { check(options); }).find(name), std::string::npos) << name;
  }
}

TEST(CheckOptions, EveryDoorThatTakesOptionsBeginsWithIt) {
  Context context;
  const Mesh mesh = generate(plate(), {}, context).mesh;
  for (const double growth : {0.5, kNan}) {
    const Options bad{.growth = growth};
    const std::string expected = refusal([&] { check(bad); });
    ASSERT_NE(expected, "");
    EXPECT_EQ(refusal([&] { generate(plate(), bad, context); }), expected);
    EXPECT_EQ(refusal([&] { edge_sizes(mesh, plate(), bad, context); }), expected);
    EXPECT_EQ(refusal([&] { verify(mesh, plate(), bad, context); }), expected);
    EXPECT_EQ(refusal([&] { estimate(plate(), bad, context); }), expected);
    EXPECT_EQ(refusal([&] { describe(plate(), bad, context); }), expected);
  }
}

TEST(InternalErrors, NameTheFileWithoutItsFolders) {
  try {
    QUADLINE_CHECK(1 + 1 == 3);
    FAIL() << "the check passed";
  } catch (const InternalError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("1 + 1 == 3 (check_options_test.cpp:"), text.npos) << text;
    EXPECT_EQ(text.find('/'), text.npos) << text;
    EXPECT_EQ(error.code(), ErrorCode::Internal);
  }
}

}  // namespace
}  // namespace quadline
