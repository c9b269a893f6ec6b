#include <nlohmann/json.hpp>
#include <string>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/estimate.hpp"
#include "cli/interrupt.hpp"
#include "domain/arrange/arrange.hpp"
#include "domain/expected_quads.hpp"
#include "io/json/report_json.hpp"
#include "io/read_model.hpp"
#include "io/text/names.hpp"

namespace quadline {

namespace {

using Json = nlohmann::ordered_json;

/// What is known of a model; without the domain where the model is wrong.
struct Facts {
  Model model;
  Domain domain;
  double area = 0, expected_quads = 0;
};

Facts facts_of(const InfoArguments& arguments) {
  Facts facts{.model = read_model(arguments.model, arguments.options.size), .domain = {}};
  check_size_given(facts.model, arguments.options);
  Context context;
  context.is_cancelled = is_interrupted;
  facts.domain = arrange(facts.model, arguments.options, context);
  facts.area = area_of(facts.domain);
  facts.expected_quads = expected_quads(facts.domain, arguments.options);
  return facts;
}

std::string text_of(const Facts& facts) {
  const Model& model = facts.model;
  const Domain& domain = facts.domain;
  const std::string unit = model.units.empty() ? "" : ' ' + printable(model.units);
  const auto number = [](std::size_t n) { return std::to_string(n); };
  std::string out =
      printable((model.name.empty() ? model.file : model.name) + (model.about.empty() ? "" : ": " + model.about)) +
      '\n';
  const std::vector<std::pair<const char*, std::string>> rows = {
      {"size", rounded(domain.size, 6) + unit},
      {"outer loops", number(model.outer.size())},
      {"holes", number(model.holes.size())},
      {"lines", number(model.lines.size())},
      {"points", number(model.points.size())},
      {"regions", number(model.regions.size())},
      {"cells", number(domain.cells.count())},
      {"curves between vertices", number(domain.curves.count())},
      {"vertices", number(domain.vertices.count())},
      {"area", rounded(facts.area, 6) + (unit.empty() ? "" : unit + "^2")},
      {"box", '(' + rounded(domain.box.lo.x, 6) + ", " + rounded(domain.box.lo.y, 6) + ") to (" +
                  rounded(domain.box.hi.x, 6) + ", " + rounded(domain.box.hi.y, 6) + ')'},
      {"tolerance", rounded(domain.tolerance, 3) + unit},
      {"expected quads", "about " + rounded(facts.expected_quads, 2)},
      {"mended", counted(domain.findings.size(), "finding", "findings")}};
  for (const auto& [name, value] : rows) out += "  " + std::string(name) + ": " + value + '\n';
  for (const Finding& finding : domain.findings)
    out += "  - " +
           std::string(InputError(loudness(finding) + finding.text, Where{{}, finding.place, finding.at}).what()) +
           '\n';
  return out;
}

Json json_of(const Facts& facts) {
  const Model& model = facts.model;
  const Domain& domain = facts.domain;
  return {{"ok", true},
          {"file", model.file},
          {"name", model.name},
          {"about", model.about},
          {"units", model.units},
          {"size", domain.size},
          {"outer_loops", model.outer.size()},
          {"holes", model.holes.size()},
          {"lines", model.lines.size()},
          {"points", model.points.size()},
          {"regions", model.regions.size()},
          {"cells", domain.cells.count()},
          {"curves", domain.curves.count()},
          {"vertices", domain.vertices.count()},
          {"area", facts.area},
          {"box", {quadline::json_of(domain.box.lo), quadline::json_of(domain.box.hi)}},
          {"tolerance", domain.tolerance},
          {"expected_quads", facts.expected_quads},
          {"findings", quadline::json_of(domain.findings)}};
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
