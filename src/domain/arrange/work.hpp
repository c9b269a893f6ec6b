#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/check.hpp"
#include "base/id.hpp"
#include "domain/domain.hpp"
#include "geom/curve.hpp"
#include "quadline/context.hpp"
#include "quadline/model.hpp"
#include "quadline/options.hpp"
#include "quadline/report.hpp"
#include "search/box_tree.hpp"

/// The steps of `arrange`, private to it: read_input, add_rings, resolve, subdivide, classify, to_domain, in this
/// order.
namespace quadline::arrangement {

/// Who keeps its place when vertices merge: the first of these.
enum class Rank : std::uint8_t {
  Corner,    ///< an end or a corner of the model's paths
  Point,     ///< a point constraint
  Crossing,  ///< computed
  Helper,    ///< only there to cut an arc into parts of at most half a turn
};

struct Vertex {
  Point at{};
  Rank rank = Rank::Crossing;
  bool checked = false;  ///< against the pieces near it
};

/// A piece of curve between two vertices; an arc makes at most half a turn.
struct Piece {
  VertexId tail{}, head{};
  CurvePiece curve{};
  std::uint32_t origin = 0;     ///< the step of a path it was cut from, in its direction
  bool checked_near = false;    ///< against the vertices near it
  bool checked_across = false;  ///< against the pieces that may cross it
};

/// What a path of the model has become so far.
struct Route {
  std::string name{};
  CurveKind kind = CurveKind::Line;
  std::string where{};
  double size = 0;                    ///< infinity: none
  double area = 0;                    ///< loops: signed, as given
  bool is_flat = false;               ///< loops: no area to speak of
  Point start{};                      ///< as given
  std::vector<DirectedCurve> uses{};  ///< pieces in order
};

/// A circle of the model that asks for a number of edges, or for rings round it.
struct Washer {
  std::uint32_t route;  ///< of the circle
  std::uint32_t edges;  ///< 0: by the sizes
  std::uint32_t rings;  ///< that have room
  std::uint32_t outer;  ///< where there are rings: route of the circle round them
};

struct Work {
  const Model& model;
  double size = 0;
  double tolerance = 0;
  double rounding = 0;  ///< distance below which joining two things is no finding
  Box box{};            ///< of the outer loops
  IdVector<VertexId, Vertex> vertices{};
  IdVector<CurveId, Piece> pieces{};
  std::vector<CurvePiece> steps{};  ///< of the paths, as given; `origin` counts them
  std::vector<Route> routes{};      ///< outer loops, holes, lines, in the order of the model; then circles round rings
  std::vector<Washer> washers{};    ///< in the order of the routes
  std::vector<VertexId> point_vertex{};  ///< of every point of the model
  std::vector<Finding> findings{};

  /// Makes a finding of two things that the tolerance has joined, `gap` apart at `at`.
  void report_joined(const char* what, double gap, Point at);

  Where where(std::string place, Point at) const {
    return {.file = model.file, .place = std::move(place), .point = at};
  }
};

/// Warnings of line ends and points that lie off a curve by more than the tolerance, but by so little beside the size
/// that elements have to become as small; and of curves that come as near to each other and do not meet there.
/// O(n log n) where boxes of curves overlap little.
void report_near_misses(const Domain& domain, const Options& options, std::vector<Finding>& findings);

constexpr double kNear = 0.1;  ///< what is nearer and not joined is told; in sizes

/// Two of the domain's paths, the lesser index first.
using PathPair = std::pair<std::uint32_t, std::uint32_t>;

/// Of every curve the first path along it.
IdVector<CurveId, std::uint32_t> first_paths(const Domain& domain);

/// The second part of `report_near_misses`: one finding for every two paths with such curves, at their least gap.
/// @param told  paths that need none.
void report_curves_beside(const Domain& domain, const Options& options, const std::set<PathPair>& told,
                          std::vector<Finding>& findings);

/// A length as findings tell it.
std::string digits(double length);

/// Checks the model and lays out its paths, as they are. @throws InputError
Work read_input(const Model& model, const Options& options);

/// Lays out a circle: two pieces, from its east to its west and back.
void add_circle(Work& work, const Circle& circle, Route& route);

/// Lays out a circle round the rings that a circle of the model asks for, as far as there is room: a third of their
/// width stays free beyond them. What there is no room for is a finding. O((n + m) log n) for n pieces and m of them
/// near the rings.
/// @throws InputError where the rings alone need more quads than allowed.
void add_rings(Work& work, const Options& options);

/// Merges vertices, cuts pieces at vertices and crossings, drops pieces without length and repeated ones, until nothing
/// changes. @throws InputError where that does not end.
void resolve(Work& work, Context& context);

/// A piece is cut at vertices within this part of the tolerance; vertices merge within all of it. So of three vertices
/// that stand apart no two can lie on the opposite sides, and no two pieces cut each other in turn for ever.
constexpr double kTouch = 0.5;

/// Makes one vertex of those within the tolerance, the better ranked and earlier first, and one piece of those that
/// touch all along; drops pieces whose ends have become one. @param report  makes findings of those.
void merge(Work& work, bool report);

/// A vertex on a piece, at arc length s.
struct Cut {
  CurveId piece;
  double s;
  VertexId vertex;
};
void cut_pieces(Work& work, std::vector<Cut>& cuts);

/// Turns and scales an arc so that it goes through its ends, if they lie farther than `slack` off its circle. Then what
/// holds for straight pieces holds for arcs: a point of the piece near its end is near no other piece that its end is
/// not.
CurvePiece moved_to_ends(CurvePiece arc, double slack);

/// The part of a curve from one arc length to another, with ends that may lie off it by the tolerance.
CurvePiece cut_curve(const Work& work, const CurvePiece& whole, double from, double to, Point a, Point b);

/// Places where p and q cross or touch, away from their ends; at most two. A lens as thin as a touch counts as one.
/// @pre no end of one touches the other, but for shared ones.
std::vector<Point> meetings(const Piece& p, const Piece& q, double tolerance);

/// Does p lie in the sector of the arc, as seen from its center? The arc makes hardly more than half a turn.
bool is_beside(const CurvePiece& arc, Point p);

/// Distance of p from the nearest point of the piece; an arc makes at most half a turn.
double distance_to(const CurvePiece& piece, Point p);

/// Half-edges are numbered: 2 * piece, and + 1 for the way back.
using Half = std::uint32_t;
constexpr Half kNoHalf = UINT32_MAX;

inline CurveId piece_of(Half half) { return CurveId(half / 2); }
inline bool is_reversed(Half half) { return half % 2 == 1; }
inline VertexId tail_of(const Work& work, Half half) {
  const Piece& piece = work.pieces[piece_of(half)];
  return is_reversed(half) ? piece.head : piece.tail;
}

/// For every half-edge the one that follows it round the face on its left.
std::vector<Half> next_halves(const Work& work);

/// Finds what lies below a point, for some meaning of "below": one of kDirections slanted ones, in general position to
/// the directions that models prefer.
class RayCaster {
 public:
  static constexpr unsigned kDirections = 8;

  /// @param component  of every piece.
  RayCaster(const Work& work, const std::vector<std::uint32_t>& component);

  struct Hit {
    Half half = kNoHalf;   ///< on the side that the ray comes from; kNoHalf: nothing is below
    bool is_clear = true;  ///< false: too near to an end of a piece to be sure
  };
  /// @param skip  the component that the ray starts on, if any.
  Hit cast(Point from, unsigned k, std::uint32_t skip = UINT32_MAX) const;

  static Point direction(unsigned k);

 private:
  const Work& work_;
  const std::vector<std::uint32_t>& component_;
  BoxTree tree_;
  double margin_;
};

/// A connected part of the plane between the curves.
struct Face {
  std::vector<std::uint32_t> walks{};  ///< the outer one first, but for face 0, the unbounded one
  int outer = 0, holes = 0;            ///< how many outer loops and holes are round it
  bool is_inside() const { return outer - holes == 1; }
};

struct Subdivision {
  std::vector<std::vector<Half>> walks;     ///< with the face on their left
  std::vector<std::uint32_t> walk_of;       ///< of every half-edge
  std::vector<std::uint32_t> face_of;       ///< of every walk
  std::vector<std::uint32_t> component_of;  ///< connected component of every piece
  std::vector<Face> faces;

  std::uint32_t face_at(Half half) const { return face_of[walk_of[half]]; }
  bool is_inside(Half half) const { return faces[face_at(half)].is_inside(); }
  bool is_kept(CurveId piece) const { return is_inside(2 * piece.value) || is_inside(2 * piece.value + 1); }
};

/// Walks and faces. @pre resolve(work) is done. @throws InputError where curves cannot be told apart.
Subdivision subdivide(const Work& work);

/// Counts the loops round every face. @throws InputError where loops overlap, cross themselves, or lie outside.
void classify(Work& work, Subdivision& parts);

/// Where pieces that are kept are joined to one curve.
struct Joints {
  IdVector<VertexId, bool> is_joint;   ///< computed, with two pieces of the same step of a path and nothing else
  IdVector<VertexId, CurveId> out_of;  ///< of joints: the piece that starts there
  std::set<VertexId> moved;            ///< kept on a whole circle, opposite to its other vertex
  IdVector<CurveId, std::vector<std::uint32_t>> routes;  ///< along each piece, without repeats
};
Joints find_joints(Work& work, const Subdivision& parts);

/// The domain: what lies inside, with names, sizes and findings.
Domain to_domain(Work& work, const Subdivision& parts);

}  // namespace quadline::arrangement
