#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/criteria_table.hpp"
#include "cli/interrupt.hpp"
#include "cli/quality_table.hpp"
#include "io/json/report_json.hpp"
#include "io/text/names.hpp"
#include "quadline/faults.hpp"
#include "quadline/inspect.hpp"
#include "quadline/io/mesh_io.hpp"
#include "quadline/io/read_criteria.hpp"
#include "quadline/io/read_model.hpp"

namespace quadline {

namespace {

using Json = nlohmann::ordered_json;

/// What was found out about a mesh.
struct Verdict {
  Mesh mesh;
  Quality quality;
  std::vector<LineQuality> lines;
  std::vector<CellCorner> corners;  ///< of the model, if there is one
  std::vector<WorstQuad> worst;
  std::vector<MeshFault> faults;
  bool all_quad = false;                   ///< asked for
  std::optional<Failure> broken;           ///< of what the model asks for
  std::optional<CriteriaResult> criteria;  ///< what fails of them

  bool is_valid() const {
    for (const MeshFault& fault : faults)
      if (fault.count > 0) return false;
    return !broken && !(all_quad && quality.n_triangles > 0);
  }
};

Verdict verdict_on(const CheckArguments& arguments) {
  Verdict verdict;
  Context context;
  context.is_cancelled = is_interrupted;
  std::optional<Criteria> criteria;
  if (!arguments.criteria.empty()) criteria = read_criteria(arguments.criteria);
  std::optional<Model> model;
  if (!arguments.model.empty()) model = read_model(arguments.model);
  verdict.mesh = read_mesh(arguments.mesh);
  std::vector<double> sizes;
  if (model) {
    Verification against = verify(verdict.mesh, *model, arguments.options, context);
    verdict.broken = std::move(against.broken);
    verdict.corners = std::move(against.corners);
    sizes = std::move(against.edge_sizes);
  }
  verdict.quality = measure(verdict.mesh, sizes);
  verdict.worst = worst_quads(verdict.mesh, verdict.corners);
  verdict.lines = measure_lines(verdict.mesh, sizes);
  verdict.faults = find_faults(verdict.mesh);
  verdict.all_quad = arguments.all_quad;
  if (criteria) verdict.criteria = evaluate(verdict.mesh, *criteria, sizes);
  return verdict;
}

std::string text_of(const Verdict& verdict, const CheckArguments& arguments) {
  const Mesh& mesh = verdict.mesh;
  std::string out = shown(arguments.mesh.string()) + ": " + counted(mesh.quads.size(), "quad", "quads") + ", " +
                    counted(mesh.triangles.size(), "triangle", "triangles") + ", " +
                    counted(mesh.points.size(), "node", "nodes") + ", " +
                    counted(mesh.regions.size(), "region", "regions") + ", " +
                    counted(mesh.curves.size(), "curve", "curves") + '\n';
  out += std::string("valid: ") + (verdict.is_valid() ? "yes" : "no") + '\n';
  for (const MeshFault& fault : verdict.faults) {
    if (fault.count == 0) continue;
    const std::string line = std::to_string(fault.count) + ' ' + fault.what + ", the first";
    out += "  - " + std::string(InputError(line, Where{{}, {}, fault.first}).what()) + '\n';
  }
  if (verdict.all_quad && !mesh.triangles.empty()) out += "  - not all elements are quads\n";
  if (!arguments.model.empty() && !verdict.broken)
    out += "against the model: kept: " + shown(arguments.model.string()) + '\n';
  if (const auto& broken = verdict.broken)
    out += "  - against the model: " + std::string(InputError(broken->reason, Where{{}, {}, broken->at}).what()) + '\n';
  out += quality_table(verdict.quality) + corner_line(verdict.corners, verdict.quality) + worst_table(verdict.worst) +
         line_table(verdict.lines);
  return verdict.criteria ? out + criteria_table(arguments.criteria, *verdict.criteria) : out;
}

Json json_of(const Verdict& verdict, const CheckArguments& arguments) {
  Json faults = Json::array();
  for (const MeshFault& fault : verdict.faults) {
    faults.push_back({{"what", fault.what}, {"count", fault.count}});
    if (fault.count > 0) faults.back()["first_at"] = quadline::json_of(fault.first);
  }
  Json out = {{"file", arguments.mesh.string()}, {"valid", verdict.is_valid()}, {"faults", faults}};
  if (!arguments.model.empty()) {
    Json broken;
    if (const auto& b = verdict.broken) broken = {{"reason", b->reason}, {"at", quadline::json_of(b->at)}};
    out["model"] = {{"file", arguments.model.string()}, {"kept", !verdict.broken}, {"broken", broken}};
  }
  out["quality"] = quadline::json_of(verdict.quality);
  if (!arguments.model.empty()) out["corners"] = quadline::json_of(verdict.corners, verdict.quality);
  out["worst"] = quadline::json_of(verdict.worst);
  out["lines"] = quadline::json_of(verdict.lines);
  if (verdict.criteria) out["criteria"] = quadline::json_of(*verdict.criteria, arguments.criteria);
  return out;
}

}  // namespace

int run(const CheckArguments& arguments) {
  const Verdict verdict = verdict_on(arguments);
  print(arguments.json ? text_of(json_of(verdict, arguments)) : text_of(verdict, arguments));
  return verdict.is_valid() ? kDone : kBrokenPromise;
}

}  // namespace quadline
