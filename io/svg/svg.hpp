#pragma once

#include <string>

#include "quadline/mesh.hpp"

namespace quadline {

/// A picture of a mesh as SVG: elements coloured by their scaled Jacobian, boundary loops medium, line constraints bold
/// violet, named points as dots, a legend with the figures below.
///
/// Light: elements of one colour are one path, on a grid of whole numbers that is finer than 1/50 of the mean edge.
std::string to_svg(const Mesh& mesh);

}  // namespace quadline
