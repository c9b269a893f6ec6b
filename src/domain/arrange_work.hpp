#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/id.hpp"
#include "domain/domain.hpp"
#include "geom/curve.hpp"
#include "quadline/context.hpp"
#include "quadline/model.hpp"
#include "quadline/options.hpp"
#include "quadline/report.hpp"

/// The steps of `arrange`, private to it: read_input, resolve, subdivide, to_domain, in this order.
namespace quadline::arrangement {

/// Who keeps its place when vertices merge: the first of these.
enum class Rank : std::uint8_t {
  Corner,    ///< an end or a corner of the model's paths
  Point,     ///< a point constraint
  Crossing,  ///< computed
  Helper,    ///< only there to cut an arc into parts of at most half a turn
};

struct Vertex {
  Point at;
  Rank rank = Rank::Crossing;
  bool checked = false;  ///< against the pieces near it
};

/// A piece of curve between two vertices; an arc makes at most half a turn.
struct Piece {
  VertexId tail, head;
  CurvePiece curve;
  std::uint32_t origin = 0;     ///< the step of a path it was cut from
  bool checked_near = false;    ///< against the vertices near it
  bool checked_across = false;  ///< against the pieces that may cross it
};

/// What a path of the model has become so far.
struct Route {
  std::string name;
  CurveKind kind = CurveKind::Line;
  std::string where;
  double size = 0;                  ///< infinity: none
  double area = 0;                  ///< loops: signed, as given
  std::vector<DirectedCurve> uses;  ///< pieces in order
};

struct Work {
  const Model& model;
  double size = 0;
  double tolerance = 0;
  Box box;  ///< of the outer loops
  IdVector<VertexId, Vertex> vertices;
  IdVector<CurveId, Piece> pieces;
  std::vector<Route> routes;           ///< outer loops, holes, lines, in the order of the model
  std::vector<VertexId> point_vertex;  ///< of every point of the model
  std::vector<Finding> findings;

  Where where(std::string place, Point at) const {
    return {.file = model.file, .place = std::move(place), .point = at};
  }
};

/// Checks the model and lays out its paths, as they are. @throws InputError
Work read_input(const Model& model, const Options& options);

/// Merges vertices within the tolerance, cuts pieces at vertices and crossings, drops pieces without length and
/// repeated ones, until nothing changes. @throws InputError where that does not end.
void resolve(Work& work, Context& context);

/// Places where p and q cross or touch, away from their ends; at most two. A lens thinner than the tolerance counts as
/// one touch. @pre no end of one lies within the tolerance of the other, but for shared ones.
std::vector<Point> meetings(const Piece& p, const Piece& q, double tolerance);

/// Distance of p from the nearest point of the piece; an arc makes at most half a turn.
double distance_to(const CurvePiece& piece, Point p);

/// Twice the signed area that the line from `origin` sweeps as its other end goes along the piece.
double twice_area_under(const CurvePiece& piece, Point origin);

/// A connected set of points of the plane without curves.
struct Face {
  std::vector<std::uint32_t> walks;  ///< the outer one first; the unbounded face has none
  bool has_outer_walk = false;
  bool inside = false;  ///< part of the domain
};

/// Half-edges are numbered: 2 * piece, and + 1 for the way back.
struct Subdivision {
  std::vector<std::vector<std::uint32_t>> walks;  ///< half-edges with the face on their left
  std::vector<std::uint32_t> walk_of;             ///< walk of a half-edge
  std::vector<std::uint32_t> face_of;             ///< face of a walk
  std::vector<Face> faces;                        ///< 0: the unbounded one

  std::uint32_t face_at(std::uint32_t half) const { return face_of[walk_of[half]]; }
};

/// Walks, faces and which of them are inside: one outer loop more round them than holes.
/// @pre resolve(work) is done. @throws InputError where loops overlap, cross themselves, or lie outside.
Subdivision subdivide(Work& work, Context& context);

/// Half-edges of pieces that start at each vertex, counter-clockwise.
IdVector<VertexId, std::vector<std::uint32_t>> stars(const Work& work);

/// Face that holds a point. A point on a piece gets a face beside it.
class FaceFinder {
 public:
  FaceFinder(const Work& work, const Subdivision& parts);
  std::uint32_t face_at(Point p) const;

 private:
  const Work& work_;
  const Subdivision& parts_;
  RayCaster rays_;
};

/// The domain, with names, sizes and findings.
Domain to_domain(Work& work, const Subdivision& parts);

}  // namespace quadline::arrangement
