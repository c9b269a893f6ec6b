#include "cli/criteria_table.hpp"

#include "cli/console.hpp"
#include "io/text/names.hpp"

namespace quadline {

namespace {

std::string line_of(std::size_t quad, double value, Point at) {
  return "\n    quad " + std::to_string(quad + 1) + ": " + rounded(value, 4) + " at (" + rounded(at.x, 6) + ", " +
         rounded(at.y, 6) + ')';
}

}  // namespace

std::string criteria_table(const std::string& name, const CriteriaResult& result) {
  std::string out = shown(name) + ": " + counted(result.n_failing, "quad fails", "quads fail") + '\n';
  for (const LimitResult& limit : result.limits) {
    out += "  " + std::string(limit.name) + ' ' + rounded(limit.limit, 4) + ": ";
    out += limit.is_checked ? std::to_string(limit.n_failing) : "not checked, the target size is unknown";
    for (const FailingQuad& quad : limit.worst) out += line_of(quad.quad, quad.value, quad.at);
    out += '\n';
  }
  return out;
}

std::string worst_table(const std::vector<WorstQuad>& worst) {
  if (worst.empty()) return "";
  std::string out = "worst quads, scaled Jacobian over what the model's corner allows:";
  for (const WorstQuad& quad : worst) out += line_of(quad.quad, quad.value, quad.at);
  return out + '\n';
}

}  // namespace quadline
