#include "domain/size/size_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/elementary.hpp"
#include "domain/cell_locator.hpp"
#include "domain/size/size_sources.hpp"
#include "domain/size/size_tree.hpp"

namespace quadline {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

}  // namespace

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
  SizeTree tree(domain.box, sources, [&](Point p) {
    if (least == largest) return largest;
    const CellId cell = cells.at(p);
    return cell.valid() ? domain.cells[cell].size : largest;
  });
  tree.grade(logarithm(options.growth));
  SizeField field;
  field.least_edges_ = std::move(curves.least_edges);
  tree.write(field);
  context.progress("sizing", 1);
  return field;
}

}  // namespace quadline
