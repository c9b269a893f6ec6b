#include "cli/criteria_table.hpp"

#include "cli/console.hpp"

namespace quadline {

std::string criteria_table(const std::string& name, const CriteriaResult& result) {
  std::string out = name + ": " + counted(result.n_failing, "quad fails", "quads fail") + '\n';
  for (const LimitResult& limit : result.limits) {
    out += "  " + std::string(limit.name) + ' ' + rounded(limit.limit, 4) + ": ";
    out += limit.is_checked ? std::to_string(limit.n_failing) : "not checked, the target size is unknown";
    for (const FailingQuad& quad : limit.worst)
      out += "\n    quad " + std::to_string(quad.quad + 1) + ": " + rounded(quad.value, 4) + " at (" +
             rounded(quad.at.x, 6) + ", " + rounded(quad.at.y, 6) + ')';
    out += '\n';
  }
  return out;
}

}  // namespace quadline
