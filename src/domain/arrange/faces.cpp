// Third step of `arrange`, second half: walks, and which walks bound the same face.
//
// Every connected component of the curves has one walk that sees it from outside: the one with negative area. A ray
// from the component's lowest point tells on which face of the others it lies; the lowest component comes first, so
// that the face below is always known.
#include <algorithm>
#include <numeric>

#include "base/constants.hpp"
#include "domain/arrange/work.hpp"

namespace quadline::arrangement {

namespace {

struct Component {
  std::size_t n_vertices = 0, n_pieces = 0, n_walks = 0;
  double least_area = kInfinity;
  std::uint32_t outward = 0;  ///< the walk that sees it from outside
  Point lowest;
  double depth = -kInfinity;
  Half below = kNoHalf;
};

class Subdivider {
 public:
  explicit Subdivider(const Work& work) : work_(work) {}

  Subdivision run() {
    find_components();
    find_walks();
    check_genus();
    find_below();
    make_faces();
    return std::move(out_);
  }

 private:
  void find_components() {
    std::vector<std::uint32_t> parent(work_.vertices.count());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&parent](std::uint32_t v) {
      while (parent[v] != v) v = parent[v] = parent[parent[v]];
      return v;
    };
    for (const Piece& piece : work_.pieces) {
      const std::uint32_t a = root(piece.tail.value), b = root(piece.head.value);
      parent[std::max(a, b)] = std::min(a, b);
    }
    std::vector<std::uint32_t> number(parent.size(), UINT32_MAX);
    for (const Piece& piece : work_.pieces) {
      std::uint32_t& c = number[root(piece.tail.value)];
      if (c == UINT32_MAX) {
        c = static_cast<std::uint32_t>(components_.size());
        components_.emplace_back();
      }
      out_.component_of.push_back(c);
      ++components_[c].n_pieces;
    }
    for (std::uint32_t v = 0; v < parent.size(); ++v) {
      if (number[root(v)] != UINT32_MAX) ++components_[number[root(v)]].n_vertices;
    }
  }

  void find_walks() {
    const std::vector<Half> next = next_halves(work_);
    out_.walk_of.assign(next.size(), UINT32_MAX);
    for (Half start = 0; start < next.size(); ++start) {
      if (out_.walk_of[start] != UINT32_MAX) continue;
      const std::uint32_t number = static_cast<std::uint32_t>(out_.walks.size());
      std::vector<Half> walk;
      const Point origin = work_.vertices[tail_of(work_, start)].at;
      double area = 0;
      for (Half h = start; out_.walk_of[h] == UINT32_MAX; h = next[h]) {
        out_.walk_of[h] = number;
        walk.push_back(h);
        const double under = twice_area_under(work_.pieces[piece_of(h)].curve, origin);
        area += is_reversed(h) ? -under : under;
      }
      out_.walks.push_back(std::move(walk));
      Component& component = components_[out_.component_of[start / 2]];
      ++component.n_walks;
      if (area < component.least_area) component.least_area = area, component.outward = number;
    }
  }

  /// Curves in the plane without crossings obey Euler's formula; an order round a vertex that no drawing has does not.
  void check_genus() const {
    for (const Component& c : components_) {
      if (c.n_walks + c.n_vertices == c.n_pieces + 2) continue;
      throw InputError("curves here cannot be told apart: remove details finer than the tolerance",
                       work_.where("", work_.vertices[tail_of(work_, out_.walks[c.outward][0])].at));
    }
  }

  void find_below() {
    const RayCaster rays(work_, out_.component_of);
    for (unsigned k = 0; k < RayCaster::kDirections; ++k) {
      find_lowest(RayCaster::direction(k));
      bool all_clear = true;
      for (std::uint32_t c = 0; c < components_.size(); ++c) {
        const RayCaster::Hit hit = rays.cast(components_[c].lowest, k, c);
        components_[c].below = hit.half;
        all_clear = all_clear && hit.is_clear;
      }
      if (all_clear) return;
    }
  }

  void find_lowest(Point down) {
    for (Component& c : components_) c.depth = -kInfinity;
    for (std::size_t i = 0; i < work_.pieces.count(); ++i) {
      const CurvePiece& curve = work_.pieces[CurveId(i)].curve;
      Component& c = components_[out_.component_of[i]];
      const auto offer = [&](Point p) {
        const double depth = dot(down, p - work_.box.lo);
        if (depth > c.depth) c.depth = depth, c.lowest = p;
      };
      offer(curve.a);
      offer(curve.b);
      if (curve.is_arc()) {
        const Point bottom = curve.center + curve.radius * down;
        if (is_beside(curve, bottom)) offer(bottom);
      }
    }
  }

  void make_faces() {
    out_.faces.emplace_back();
    out_.face_of.assign(out_.walks.size(), UINT32_MAX);
    for (std::uint32_t w = 0; w < out_.walks.size(); ++w) {
      if (components_[out_.component_of[out_.walks[w][0] / 2]].outward != w) {
        out_.face_of[w] = static_cast<std::uint32_t>(out_.faces.size());
        out_.faces.push_back({.walks = {w}});
      }
    }
    std::vector<std::uint32_t> order(components_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) {
      return components_[a].depth != components_[b].depth ? components_[a].depth > components_[b].depth : a < b;
    });
    for (const std::uint32_t c : order) {
      const Component& component = components_[c];
      const std::uint32_t face = component.below == kNoHalf ? 0 : out_.face_at(component.below);
      QUADLINE_CHECK(face < out_.faces.size());
      out_.face_of[component.outward] = face;
    }
    // In the order of the pieces, not of depth.
    for (std::uint32_t w = 0; w < out_.walks.size(); ++w) {
      if (components_[out_.component_of[out_.walks[w][0] / 2]].outward == w) {
        out_.faces[out_.face_of[w]].walks.push_back(w);
      }
    }
  }

  const Work& work_;
  Subdivision out_;
  std::vector<Component> components_;
};

}  // namespace

Subdivision subdivide(const Work& work) { return Subdivider(work).run(); }

}  // namespace quadline::arrangement
