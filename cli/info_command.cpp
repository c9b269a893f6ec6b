#include <nlohmann/json.hpp>
#include <string>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/interrupt.hpp"
#include "cli/model_size.hpp"
#include "io/json/report_json.hpp"
#include "io/text/names.hpp"
#include "quadline/inspect.hpp"
#include "quadline/io/read_model.hpp"

namespace quadline {

namespace {

using Json = nlohmann::ordered_json;

/// What is known of a model.
struct Facts {
  Model model;
  ModelFacts found;
};

Facts facts_of(const InfoArguments& arguments) {
  Facts facts{.model = read_model(arguments.model, arguments.options.size), .found = {}};
  check_size_given(facts.model, arguments.options);
  Context context;
  context.is_cancelled = is_interrupted;
  facts.found = describe(facts.model, arguments.options, context);
  return facts;
}

std::string text_of(const Facts& facts) {
  const Model& model = facts.model;
  const ModelFacts& found = facts.found;
  const std::string unit = model.units.empty() ? "" : ' ' + shown_name(model.units);
  const auto number = [](std::size_t n) { return std::to_string(n); };
  std::string out = (model.name.empty() ? shown(model.file) : shown_name(model.name)) +
                    (model.about.empty() ? "" : ": " + shown(model.about)) + '\n';
  const std::vector<std::pair<const char*, std::string>> rows = {
      {"size", rounded(found.size, 6) + unit},
      {"outer loops", number(model.outer.size())},
      {"holes", number(model.holes.size())},
      {"lines", number(model.lines.size())},
      {"points", number(model.points.size())},
      {"regions", number(model.regions.size())},
      {"cells", number(found.n_cells)},
      {"curves between vertices", number(found.n_curves)},
      {"vertices", number(found.n_vertices)},
      {"area", rounded(found.expected.area, 6) + (unit.empty() ? "" : unit + "^2")},
      {"box", '(' + rounded(found.low.x, 6) + ", " + rounded(found.low.y, 6) + ") to (" + rounded(found.high.x, 6) +
                  ", " + rounded(found.high.y, 6) + ')'},
      {"tolerance", rounded(found.tolerance, 3) + unit},
      {"expected quads", "about " + rounded(found.expected.quads, 2)},
      {"mended", counted(found.findings.size(), "finding", "findings")}};
  for (const auto& [name, value] : rows) out += "  " + std::string(name) + ": " + value + '\n';
  for (const Finding& finding : found.findings)
    out += "  - " +
           std::string(InputError(loudness(finding) + finding.text, Where{{}, finding.place, finding.at}).what()) +
           '\n';
  return out;
}

Json json_of(const Facts& facts) {
  const Model& model = facts.model;
  const ModelFacts& found = facts.found;
  return {{"ok", true},
          {"file", model.file},
          {"name", model.name},
          {"about", model.about},
          {"units", model.units},
          {"size", found.size},
          {"outer_loops", model.outer.size()},
          {"holes", model.holes.size()},
          {"lines", model.lines.size()},
          {"points", model.points.size()},
          {"regions", model.regions.size()},
          {"cells", found.n_cells},
          {"curves", found.n_curves},
          {"vertices", found.n_vertices},
          {"area", found.expected.area},
          {"box", {quadline::json_of(found.low), quadline::json_of(found.high)}},
          {"tolerance", found.tolerance},
          {"expected_quads", found.expected.quads},
          {"findings", quadline::json_of(found.findings)}};
}

Json json_of(const InputError& error) {
  const Where& where = error.where();
  return {{"ok", false},
          {"error", error.what()},
          {"file", where.file},
          {"place", where.place},
          {"at", where.point ? quadline::json_of(*where.point) : Json()}};
}

}  // namespace

int run(const InfoArguments& arguments) {
  if (!arguments.json) {
    print(text_of(facts_of(arguments)));
    return kDone;
  }
  try {
    print(text_of(json_of(facts_of(arguments))));
  } catch (const InputError& error) {
    print(text_of(json_of(error)));
    throw;
  }
  return kDone;
}

}  // namespace quadline
