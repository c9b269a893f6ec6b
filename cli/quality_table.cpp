#include "cli/quality_table.hpp"

#include <algorithm>
#include <vector>

#include "cli/console.hpp"
#include "io/text/names.hpp"

namespace quadline {

namespace {

using Row = std::vector<std::string>;

std::string share(std::size_t part, std::size_t whole) {
  return whole == 0 ? "-" : fixed(100.0 * static_cast<double>(part) / static_cast<double>(whole), 1) + " %";
}

Row row_of(const std::string& name, const Statistics& s, int digits) {
  Row row = {name};
  for (const double value : {s.min, s.p1, s.p5, s.median, s.p95, s.p99, s.max, s.mean})
    row.push_back(digits < 0 ? rounded(value, 4) : fixed(value, digits));
  return row;
}

}  // namespace

std::string before_and_after(const Quality& before, const Quality& after) {
  const auto row = [&](const char* name, auto text) { return Row{name, text(before), text(after)}; };
  std::vector<Row> rows = {{"", "before smoothing", "after"}};
  rows.push_back(row("beta, mean", [](const Quality& q) { return fixed(q.beta_mean, 3); }));
  rows.back().push_back(std::string(verdict(after.beta_mean)));
  rows.push_back(row("beta, least", [](const Quality& q) { return fixed(q.beta_min, 3); }));
  rows.push_back(row("scaled Jacobian, mean", [](const Quality& q) { return fixed(q.scaled_jacobian.mean, 3); }));
  rows.push_back(row("scaled Jacobian, least", [](const Quality& q) { return fixed(q.scaled_jacobian.min, 3); }));
  rows.push_back(row("least angle, degrees", [](const Quality& q) { return fixed(q.min_angle_deg.min, 1); }));
  rows.push_back(row("greatest angle, degrees", [](const Quality& q) { return fixed(q.max_angle_deg.max, 1); }));
  if (after.edge_to_size) {
    rows.push_back({"edge length / size, least", "", fixed(after.edge_to_size->min, 2)});
    rows.push_back({"edge length / size, median", "", fixed(after.edge_to_size->median, 2)});
    rows.push_back({"edge length / size, greatest", "", fixed(after.edge_to_size->max, 2)});
  }
  rows.push_back({"growth, 95 %", "", fixed(after.growth.p95, 2)});
  rows.push_back({"growth, greatest", "", fixed(after.growth.max, 2)});
  rows.push_back(row("irregular nodes", [](const Quality& q) { return std::to_string(q.n_irregular); }));
  rows.back().push_back(share(after.n_irregular, after.n_nodes));
  return aligned(rows);
}

std::string quality_table(const Quality& quality) {
  std::vector<Row> rows = {{"", "least", "1 %", "5 %", "median", "95 %", "99 %", "greatest", "mean"}};
  rows.push_back({"beta", fixed(quality.beta_min, 3), "", "", "", "", "", "", fixed(quality.beta_mean, 3),
                  std::string(verdict(quality.beta_mean))});
  rows.push_back(row_of("scaled Jacobian", quality.scaled_jacobian, 3));
  rows.push_back(row_of("least angle, degrees", quality.min_angle_deg, 1));
  rows.push_back(row_of("greatest angle, degrees", quality.max_angle_deg, 1));
  rows.push_back(row_of("longest / shortest edge", quality.aspect, 2));
  rows.push_back(row_of("edge length", quality.edge_length, -1));
  if (quality.edge_to_size) rows.push_back(row_of("edge length / size", *quality.edge_to_size, 2));
  rows.push_back(row_of("growth", quality.growth, 2));
  return aligned(rows) + "  irregular nodes: " + std::to_string(quality.n_irregular) + " (" +
         share(quality.n_irregular, quality.n_nodes) + ")\n";
}

std::string corner_line(const std::vector<CellCorner>& corners, const Quality& quality) {
  const auto least = std::min_element(corners.begin(), corners.end(),
                                      [](const CellCorner& a, const CellCorner& b) { return a.sj_bound < b.sj_bound; });
  if (least == corners.end()) return "";
  std::string out = "  corners of the model allow a least scaled Jacobian of " + fixed(least->sj_bound, 3);
  if (least->sj_bound > 1e-9) out += ", reached " + fixed(quality.scaled_jacobian.min / least->sj_bound, 3) + " of it";
  return out + ": " + counted(least->quads, "quad", "quads") + " in " + fixed(least->angle_deg, 1) + " degrees at (" +
         rounded(least->at.x, 6) + ", " + rounded(least->at.y, 6) + ")\n";
}

std::string line_table(std::vector<LineQuality> lines) {
  constexpr std::size_t kMost = 10;
  std::erase_if(lines, [](const LineQuality& line) { return line.kind != CurveKind::Line || line.n_quads == 0; });
  if (lines.empty()) return "";
  std::stable_sort(lines.begin(), lines.end(),
                   [](const LineQuality& a, const LineQuality& b) { return a.beta_min < b.beta_min; });
  const std::size_t n_left_out = lines.size() - std::min(kMost, lines.size());
  lines.resize(lines.size() - n_left_out);
  std::vector<Row> rows = {{"line, the worst first", "edges", "quads", "beta least", "mean", "SJ least", "mean",
                            "angles", "edge / size", "irregular", "off normal"}};
  for (const LineQuality& line : lines) {
    const auto& r = line.edge_to_size;
    rows.push_back({shown_name(line.name), std::to_string(line.n_edges), std::to_string(line.n_quads),
                    fixed(line.beta_min, 3), fixed(line.beta_mean, 3), fixed(line.scaled_jacobian_min, 3),
                    fixed(line.scaled_jacobian_mean, 3),
                    fixed(line.min_angle_deg, 0) + ".." + fixed(line.max_angle_deg, 0),
                    r ? fixed(r->min, 2) + ".." + fixed(r->max, 2) : "-", std::to_string(line.n_irregular),
                    line.off_normal_deg ? fixed(*line.off_normal_deg, 1) : "-"});
  }
  std::string out = aligned(rows);
  if (n_left_out > 0) out += "  and " + counted(n_left_out, "better line", "better lines") + '\n';
  return out;
}

}  // namespace quadline
