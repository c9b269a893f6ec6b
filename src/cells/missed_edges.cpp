#include "cells/missed_edges.hpp"

#include <string>

namespace quadline {

void append_missed_edges(const Domain& domain, const Mesh& mesh, std::vector<Finding>& findings) {
  for (const Domain::Washer& washer : domain.washers) {
    const EdgeSet& circle = mesh.curves[washer.path];
    if (washer.edges == 0 || circle.edges.size() == washer.edges) continue;
    const char* why = washer.edges % 4 != 0 ? "edges here are halved: ask for a multiple of four"
                                            : "another curve is too near for so few: ask for more";
    findings.push_back({"'" + circle.name + "' has " + std::to_string(circle.edges.size()) + " edges in place of " +
                            std::to_string(washer.edges) + ": " + why,
                        {},
                        domain.curves[washer.circles[0][0].curve].piece.a,
                        true});
  }
}

}  // namespace quadline
