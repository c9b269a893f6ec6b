#include "io/json/report_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

namespace quadline {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kForcedBelow = 0.5 * std::numbers::sqrt2;  // the sine of 45 degrees

Json json_of(const Statistics& s) {
  return {{"min", s.min}, {"p1", s.p1},   {"p5", s.p5},   {"median", s.median},
          {"p95", s.p95}, {"p99", s.p99}, {"max", s.max}, {"mean", s.mean}};
}

const char* name_of(Method method) {
  switch (method) {
    case Method::Layout:
      return "layout";
    case Method::QMorph:
      return "qmorph";
    case Method::Merge:
      return "merge";
    case Method::Split:
      return "split";
  }
  return "";
}

const char* name_of(Triangles triangles) {
  return triangles == Triangles::Delaunay ? "delaunay" : triangles == Triangles::Front ? "front" : "both";
}

Json options_of(const Run& run) {
  const Options& options = run.options;
  Json out{{"size", options.size.value_or(run.model.size)},
           {"growth", options.growth},
           {"edges_per_circle", options.edges_per_circle},
           {"lines", options.lines == LineFronts::OneSided ? "one-sided" : "two-sided"},
           {"triangles", name_of(options.triangles)},
           {"method", name_of(options.method)},
           {"threads", run.threads}};
  if (options.tolerance) out["tolerance"] = *options.tolerance;
  return out;
}

Json stages_of(const Run& run) {
  Json out = Json::array();
  for (const StageUse& use : run.stages)
    out.push_back({{"stage", use.stage}, {"seconds", use.elapsed_s}, {"peak_memory_bytes", use.peak_bytes}});
  return out;
}

Json json_of(const CellOrigins::Share& share) { return {{"cells", share.n_cells}, {"quads", share.n_quads}}; }

Json json_of(const CellOrigins& cells) {
  return {{"grids", json_of(cells.grids)},
          {"qmorph", json_of(cells.fronts)},
          {"halved", json_of(cells.halved)},
          {"copies", json_of(cells.copies)}};
}

Json json_of(const MorphCounts& counts) {
  Json states;
  std::size_t n_quads = 0;
  for (std::size_t tail = 0; tail < counts.quads.size(); ++tail)
    for (std::size_t head = 0; head < counts.quads[tail].size(); ++head) {
      n_quads += counts.quads[tail][head];
      states[std::to_string(tail) + '-' + std::to_string(head)] = counts.quads[tail][head];
    }
  return {{"triangles", counts.n_triangles},
          {"steps", n_quads},
          {"states", states},
          {"side_edges",
           {{"neighbour", counts.side_neighbour},
            {"chosen", counts.side_chosen},
            {"swapped", counts.side_swapped},
            {"split_for_parity", counts.side_split_parity},
            {"split_for_length", counts.side_split_length},
            {"split_for_direction", counts.side_split_direction}}},
          {"top_edges", {{"found", counts.top_found}, {"swapped", counts.top_swapped}}},
          {"seams", counts.seams},
          {"transition_seams", counts.transition_seams},
          {"transition_splits", counts.transition_splits},
          {"closures",
           {{"of_4", counts.closures_of_4},
            {"of_6_by_2", counts.closures_of_6_by_2},
            {"of_6_by_3", counts.closures_of_6_by_3}}},
          {"completion", {{"triangles", counts.completion_triangles}, {"quads", counts.completion_quads}}},
          {"refused",
           {{"side_edge", counts.refused_side}, {"top_edge", counts.refused_top}, {"shape", counts.refused_shape}}}};
}

}  // namespace

Json json_of(Point p) { return {p.x, p.y}; }

Json json_of(const Quality& quality) {
  Json out = {{"nodes", quality.n_nodes},
              {"quads", quality.n_quads},
              {"triangles", quality.n_triangles},
              {"inverted", quality.n_inverted},
              {"irregular_nodes", quality.n_irregular},
              {"beta_mean", quality.beta_mean},
              {"beta_min", quality.beta_min},
              {"verdict", std::string(verdict(quality.beta_mean))},
              {"scaled_jacobian", json_of(quality.scaled_jacobian)},
              {"min_angle_deg", json_of(quality.min_angle_deg)},
              {"max_angle_deg", json_of(quality.max_angle_deg)},
              {"aspect", json_of(quality.aspect)},
              {"edge_length", json_of(quality.edge_length)},
              {"growth", json_of(quality.growth)},
              {"growth_limit", kGrowthLimit},
              {"growth_over_limit", quality.n_growth_over}};
  if (quality.edge_to_size) out["edge_to_size"] = json_of(*quality.edge_to_size);
  return out;
}

Json json_of(const std::vector<LineQuality>& lines) {
  Json out = Json::array();
  for (const LineQuality& line : lines) {
    out.push_back({{"name", line.name},
                   {"kind", line.kind == CurveKind::Outer  ? "outer"
                            : line.kind == CurveKind::Hole ? "hole"
                                                           : "line"},
                   {"edges", line.n_edges},
                   {"quads", line.n_quads},
                   {"irregular_nodes", line.n_irregular},
                   {"beta_mean", line.beta_mean},
                   {"beta_min", line.beta_min},
                   {"scaled_jacobian_mean", line.scaled_jacobian_mean},
                   {"scaled_jacobian_min", line.scaled_jacobian_min},
                   {"min_angle_deg", line.min_angle_deg},
                   {"max_angle_deg", line.max_angle_deg}});
    if (const auto& r = line.edge_to_size)
      out.back()["edge_to_size"] = {{"min", r->min}, {"mean", r->mean}, {"max", r->max}};
    if (line.off_normal_deg) out.back()["off_normal_deg"] = *line.off_normal_deg;
  }
  return out;
}

Json json_of(const std::vector<CellCorner>& corners, const Quality& quality) {
  Json forced = Json::array();
  for (const CellCorner& corner : corners) {
    if (corner.sj_bound > kForcedBelow - 1e-9) continue;
    forced.push_back({{"at", json_of(corner.at)},
                      {"angle_deg", corner.angle_deg},
                      {"quads", corner.quads},
                      {"best_angle_deg", corner.best_angle_deg},
                      {"sj_bound", corner.sj_bound}});
  }
  const double bound = jacobian_bound(corners), least = quality.scaled_jacobian.min;
  Json over;
  if (bound > 1e-9) over = least / bound;
  return {{"sj_bound", bound}, {"sj_min", least}, {"sj_min_over_bound", over}, {"forced", forced}};
}

Json json_of(const std::vector<WorstQuad>& worst) {
  Json out = Json::array();
  for (const WorstQuad& quad : worst)
    out.push_back({{"quad", quad.quad + 1},
                   {"at", json_of(quad.at)},
                   {"value", quad.value},
                   {"scaled_jacobian", quad.scaled_jacobian},
                   {"sj_bound", quad.sj_bound}});
  return out;
}

Json json_of(const std::vector<Finding>& findings) {
  Json out = Json::array();
  for (const Finding& finding : findings)
    out.push_back(
        {{"text", finding.text}, {"place", finding.place}, {"at", json_of(finding.at)}, {"loss", finding.is_loss}});
  return out;
}

Json json_of(const CriteriaResult& result, const std::string& name) {
  Json limits = Json::array();
  for (const LimitResult& limit : result.limits) {
    Json worst = Json::array();
    for (const FailingQuad& quad : limit.worst)
      worst.push_back({{"quad", quad.quad + 1}, {"at", json_of(quad.at)}, {"value", quad.value}});
    limits.push_back({{"name", std::string(limit.name)},
                      {"limit", limit.limit},
                      {"checked", limit.is_checked},
                      {"failing", limit.n_failing},
                      {"worst", worst}});
  }
  return {{"name", name}, {"failing", result.n_failing}, {"limits", limits}};
}

std::string text_of(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n'; }

std::string report_json(const Run& run) {
  const Report& report = run.result.report;
  Json failure;
  if (const auto& broken = run.result.failure)
    failure = {{"stage", broken->stage}, {"reason", broken->reason}, {"at", json_of(broken->at)}};
  Json files = Json::array();
  for (const auto& file : run.files) files.push_back(file.string());
  std::size_t peak = 0;
  for (const StageUse& use : run.stages) peak = std::max(peak, use.peak_bytes);
  Json out = {{"format", "quadline-report"},
              {"version", 1},
              {"quadline", run.version},
              {"model", {{"file", run.model.file}, {"name", run.model.name}, {"units", run.model.units}}},
              {"options", options_of(run)},
              {"ok", !run.result.failure},
              {"failure", failure},
              {"tolerance", report.tolerance},
              {"counts",
               {{"cells", report.n_cells},
                {"curves", report.n_curves},
                {"vertices", report.n_vertices},
                {"nodes", report.quality.n_nodes},
                {"quads", report.quality.n_quads},
                {"triangles", report.quality.n_triangles}}},
              {"findings", json_of(report.findings)},
              {"quality",
               {{"before_smoothing", json_of(report.before_smoothing)}, {"after_smoothing", json_of(report.quality)}}},
              {"corners", json_of(report.corners, report.quality)},
              {"worst", json_of(report.worst)},
              {"lines", json_of(report.lines)},
              {"cells", json_of(report.cells)},
              {"qmorph", json_of(report.qmorph)},
              {"stages", stages_of(run)},
              {"seconds", run.elapsed_s},
              {"peak_memory_bytes", peak},
              {"files", files}};
  if (!run.criteria_name.empty()) out["criteria"] = json_of(run.criteria, run.criteria_name);
  return text_of(out);
}

}  // namespace quadline
