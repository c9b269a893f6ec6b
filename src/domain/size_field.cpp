#include "domain/size_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quadline {

std::uint32_t SizeField::least_edges(const CurvePiece& piece) const {
  if (!piece.is_arc()) return 1;
  const double turns = std::abs(piece.sweep) / (2 * std::numbers::pi);
  return std::max(1u, static_cast<std::uint32_t>(std::ceil(8 * turns - 1e-6)));
}

SizeField make_size_field(const Domain& domain, const Options&, Context&) {
  SizeField field;
  field.size_ = domain.size;
  return field;
}

}  // namespace quadline
