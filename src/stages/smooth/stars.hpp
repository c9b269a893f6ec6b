#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "domain/domain.hpp"
#include "domain/size_field.hpp"
#include "mesh/work_mesh.hpp"

namespace quadline {

/// The three other corners of a quad, counter-clockwise after the node in question.
struct Spoke {
  std::uint32_t next, opposite, previous;
};

/// The movable nodes of a mesh and the quads round each, in flat arrays: smoothing reads nothing else.
class Stars {
 public:
  Stars(WorkMesh& mesh, const Domain& domain, const SizeField& size);

  std::size_t count() const { return node_.size(); }
  std::span<const Spoke> spokes(std::size_t i) const {
    return {spokes_.data() + first_[i], spokes_.data() + first_[i + 1]};
  }
  std::uint32_t node(std::size_t i) const { return node_[i]; }
  Point at(std::size_t i) const { return point_[node_[i]]; }
  Point point(std::uint32_t node) const { return point_[node]; }
  double size(std::size_t i) const { return size_[i]; }

  /// A node on a curve slides; all others move freely.
  bool slides(std::size_t i) const { return slide_[i].curve.valid(); }
  /// The place and point on the curve of node i nearest to p, not nearer to its neighbours than they allow.
  struct Place {
    double s;
    Point point;
  };
  Place slid(std::size_t i, Point p) const;

  /// Moves node i; on a curve to the nearest place of it.
  void move(std::size_t i, Point p);

  /// Marks node i and all that share a quad with it for the next sweep.
  void wake(std::size_t i);
  void wake_self(std::size_t i) { awake_[i] = 1; }
  void wake_all();
  /// Nodes marked since the last call, in order.
  std::vector<std::uint32_t> take_awake();

  /// Writes the points back to the mesh.
  void store(WorkMesh& mesh) const;

 private:
  struct Slide {
    CurveId curve;  ///< invalid: free
    double s = 0;
    std::uint32_t before = 0, after = 0;  ///< neighbours along the curve
  };
  double place_of(std::uint32_t neighbour, const Slide& slide, bool before) const;

  const Domain& domain_;
  std::vector<Point> point_;            // of all nodes
  std::vector<std::uint32_t> star_of_;  // of all nodes: their star, or none
  std::vector<std::uint32_t> node_;     // of the stars
  std::vector<std::uint32_t> first_;
  std::vector<Spoke> spokes_;
  std::vector<Slide> slide_;
  std::vector<double> size_;
  std::vector<std::uint8_t> awake_;
};

}  // namespace quadline
