// Curves that come near to each other and do not meet there. The least distance of two pieces is at an end of one or
// where the line to a center cuts it; where that is in a corner between them, the strip behind the corner counts.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "domain/arrange/work.hpp"
#include "domain/cell_locator.hpp"
#include "domain/size/size_sources.hpp"
#include "domain/walk_places.hpp"

namespace quadline::arrangement {

namespace {

constexpr double kAcross = 0.2;         // least sine between a curve and the way to what lies beside it, not before it
constexpr double kBehindCorner = 2.01;  // in sizes, on both curves: just farther along them than a wedge reaches

class BesideFinder {
 public:
  BesideFinder(const Domain& domain, const Options& options)
      : domain_(domain),
        walks_(domain),
        tree_(boxes_of_curves(domain)),
        sizes_(curve_sizes(domain, options).sizes),
        diagonal_(distance(domain.box.lo, domain.box.hi)),
        path_of_(first_paths(domain)) {}

  void find(const std::set<PathPair>& told, std::vector<Finding>& findings) {
    for (std::size_t i = 0; i < domain_.curves.count(); ++i) {
      const CurveId a(i);
      if (domain_.curves[a].is_auxiliary) continue;
      tree_.query(inflated(tree_.box_of(i), limit(a)), [&](std::uint32_t j) {
        if (j > i && !domain_.curves[CurveId(j)].is_auxiliary &&
            !share_vertex(domain_.curves[a], domain_.curves[CurveId(j)]))
          compare(a, CurveId(j));
      });
    }
    for (const auto& [pair, near] : nearest_)
      if (!told.contains(pair)) findings.push_back({text(pair, near.gap), "", near.at});
  }

 private:
  struct Near {
    double gap;
    Point at;
  };

  double limit(CurveId c) const { return kNear * std::min(sizes_[c], diagonal_); }

  /// Keeps the least gap of the paths of two curves.
  void compare(CurveId a, CurveId b) {
    const double most = std::min(limit(a), limit(b));
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}})
      for (const double s : places(domain_.curves[from].piece, domain_.curves[to].piece, base_size(a, b)))
        look(from, s, to, most);
  }

  double base_size(CurveId a, CurveId b) const {
    return std::min(
        {quadline::base_size(domain_, domain_.curves[a]), quadline::base_size(domain_, domain_.curves[b]), diagonal_});
  }

  /// Arc lengths of a piece at which it may be nearest to another.
  static std::vector<double> places(const CurvePiece& piece, const CurvePiece& other, double base) {
    const auto [first, last] = std::minmax({project(piece, other.a), project(piece, other.b)});
    std::vector<double> found{first, last};
    if (other.is_arc()) found.push_back(project(piece, other.center));
    const double behind = kBehindCorner * base;
    if (first + 2 * behind < last) found.insert(found.end(), {first + behind, last - behind});
    found.push_back(0.5 * (first + last));
    return found;
  }

  void look(CurveId a, double s, CurveId b, double most) {
    const CurvePiece &piece = domain_.curves[a].piece, &other = domain_.curves[b].piece;
    const Point p = point_at(piece, s);
    const double t = project(other, p);
    const Point q = point_at(other, t);
    const PathPair pair = std::minmax({path_of_[a], path_of_[b]});
    const auto known = nearest_.find(pair);
    const double gap = distance(p, q);
    if (!(gap < (known == nearest_.end() ? most : std::min(most, known->second.gap)))) return;  // or from a center
    if (!is_across(piece, s, q - p) || !is_across(other, t, q - p)) return;
    const bool a_left = is_left_of(piece, s, q), b_left = is_left_of(other, t, p);
    const CellId cell = cell_on(domain_.curves[a], a_left);
    if (!cell.valid() || cell != cell_on(domain_.curves[b], b_left)) return;
    if (walks_.is_wedge(a, a_left, s, b, b_left, t, std::min(domain_.cells[cell].size, diagonal_))) return;
    nearest_.insert_or_assign(pair, Near{gap, midpoint(p, q)});
  }

  static bool is_across(const CurvePiece& piece, double s, Point way) {
    return std::abs(cross(tangent_at(piece, s), way)) > kAcross * norm(way);
  }

  std::string text(const PathPair& pair, double gap) const {
    const auto name = [&](std::uint32_t path) { return "'" + domain_.paths[path].name + "'"; };
    return name(pair.first) + " comes within " + digits(gap) + " of " +
           (pair.first == pair.second ? "itself" : name(pair.second)) +
           ": elements between become as thin; join them (--tolerance), or move them apart";
  }

  const Domain& domain_;
  const WalkPlaces walks_;
  const BoxTree tree_;
  const IdVector<CurveId, double> sizes_;
  const double diagonal_;
  const IdVector<CurveId, std::uint32_t> path_of_;
  std::map<PathPair, Near> nearest_;
};

}  // namespace

void report_curves_beside(const Domain& domain, const Options& options, const std::set<PathPair>& told,
                          std::vector<Finding>& findings) {
  BesideFinder(domain, options).find(told, findings);
}

}  // namespace quadline::arrangement
