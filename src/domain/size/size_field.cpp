#include "domain/size/size_field.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "base/elementary.hpp"
#include "domain/cell_locator.hpp"
#include "domain/size/size_sources.hpp"
#include "domain/size/size_tree.hpp"
#include "quadline/errors.hpp"

namespace quadline {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kTolerancesInSize = 4;  // a tolerance is a quarter of the least size at most

/// What Options::size_at asks for at a place of the domain's box.
double asked_at(Point p, const Domain& domain, const Options& options) {
  const double size = options.size_at(p), least = kTolerancesInSize * domain.tolerance;
  if (kLengthRange.contains(size) && size >= least) return size;
  const auto text = [](double x) {
    char buffer[32];
    return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::general, 6).ptr);
  };
  throw InputError(ErrorCode::InvalidOption,
                   "Options::size_at gives " + text(size) + ": expected a length of at least " + text(least) +
                       ", which is four tolerances",
                   Where{{}, {}, p});
}

}  // namespace

SizeField SizeField::constant(double size) {
  SizeField field;
  field.nodes_ = {kLeaf};
  field.corners_ = {{size, size, size, size}};
  return field;
}

SizeField SizeField::scaled(double factor) const {
  SizeField field = *this;
  for (std::array<double, 4>& corners : field.corners_)
    for (double& h : corners) h *= factor;
  return field;
}

SizeField make_size_field(const Domain& domain, const Options& options, Context& context) {
  context.progress("sizing", 0);
  double largest = 0, least = kNone;
  if (domain.cells.empty()) largest = least = domain.size;
  for (const Domain::Cell& cell : domain.cells) {
    largest = std::max(largest, cell.size);
    least = std::min(least, cell.size);
  }
  std::vector<SizeSource> sources;
  CurveSizes curves = curve_sizes(domain, options);
  for (std::size_t i = 0; i < domain.curves.count(); ++i) {
    const Domain::Curve& c = domain.curves[CurveId(i)];
    const bool is_border = least < largest && (!c.left.valid() || !c.right.valid() ||
                                               domain.cells[c.left].size != domain.cells[c.right].size);
    if (is_border || curves.sizes[CurveId(i)] < base_size(domain, c))
      append_sources(c.piece, 0, length(c.piece), curves.sizes[CurveId(i)], is_border, sources);
  }
  for (const Domain::PointUse& p : domain.points)
    if (p.size < largest) sources.push_back({domain.vertices[p.vertex].at, domain.vertices[p.vertex].at, p.size});
  append_gaps(domain, curves.sizes, sources);
  context.progress("sizing", 0.5);

  const CellLocator cells(domain);
  const auto base_at = [&](Point p) {
    if (least == largest) return largest;
    const CellId cell = cells.at(p);
    return cell.valid() ? domain.cells[cell].size : largest;
  };
  std::function<double(Point)> asked_by_function;
  if (options.size_at) asked_by_function = [&](Point p) { return std::min(largest, asked_at(p, domain, options)); };
  SizeTree tree(domain.box, sources, base_at, asked_by_function);
  const auto is_inside = [&](Point p) { return cells.at(p).valid(); };
  if (asked_by_function && tree.quads_asked(is_inside) > options.max_quads)
    throw InputError(ErrorCode::TooManyQuads,
                     "Options::size_at asks for more quads than allowed: give larger sizes, or raise max_quads");
  tree.grade(logarithm(options.growth));
  SizeField field;
  if (asked_by_function) field.quads_expected_ = tree.quads_graded(is_inside);
  field.least_edges_ = std::move(curves.least_edges);
  tree.write(field);
  context.progress("sizing", 1);
  return field;
}

}  // namespace quadline
