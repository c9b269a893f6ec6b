#include "cells/missed_edges.hpp"

#include <cstddef>
#include <string>

#include "domain/circle_parts.hpp"

namespace quadline {

void append_missed_edges(const Domain& domain, const Mesh& mesh, std::vector<Finding>& findings) {
  for (std::size_t i = 0; i < domain.paths.size(); ++i) {
    const Domain::Path& path = domain.paths[i];
    const std::size_t asked = given_edges(domain, path.curves), made = mesh.curves[i].edges.size();
    if (asked == 0 || asked == made) continue;
    findings.push_back({"'" + path.name + "' has " + std::to_string(made) + " edges in place of " +
                            std::to_string(asked) +
                            ": another curve is too near, or they are halved; ask for more, or for a multiple of eight",
                        path.where, domain.curves[path.curves[0].curve].piece.a, true});
  }
}

}  // namespace quadline
