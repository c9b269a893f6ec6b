#include "domain/size/size_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "base/check.hpp"
#include "quadline/errors.hpp"

// A background quadtree with gradient-limited sizes at its corners [Persson2006]. Where we differ: instead of marching
// edge by edge, which measures diagonals too long, each corner remembers who asked for its size, and the distance to
// that one is exact.

namespace quadline {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kLeafShare = 0.35;  // side of a leaf over the least size asked in it
constexpr std::size_t kMaxNodes = std::size_t{1} << 23;
constexpr int kLeastDepth = 6;  // leaves that see the size function at least, 64 along a side
constexpr double kBend =
    0.05;  // of the least size in a leaf: how far the size function may be from what its corners tell
constexpr std::size_t kMaxBent = std::size_t{1} << 17;  // leaves split for the size function alone

}  // namespace

SizeTree::SizeTree(const Box& box, const std::vector<SizeSource>& sources, const std::function<double(Point)>& base_at,
                   const std::function<double(Point)>& asked_at)
    : sources_(sources), box_(box) {
  const double width = box.hi.x - box.lo.x, height = box.hi.y - box.lo.y;
  side_ = std::max(width, height);
  origin_ = {box.lo.x - 0.5 * (side_ - width), box.lo.y - 0.5 * (side_ - height)};
  refine(asked_at);
  balance();
  for (std::uint32_t i = 0; i < nodes_.size(); ++i)
    if (!nodes_[i].below) leaves_.push_back(i);
  number_corners();
  fill_base(base_at);
  if (asked_at) take_asked(asked_at);
}

Box SizeTree::box_of(const Node& node) const {
  const double unit = side_ / SizeField::kLattice, w = unit * width(node);
  const Point lo{origin_.x + unit * node.x, origin_.y + unit * node.y};
  return {lo, {lo.x + w, lo.y + w}};
}

bool SizeTree::touches(const SizeSource& source, const Node& node) const {
  const Box box = box_of(node);
  const double half = 0.5 * (box.hi.x - box.lo.x);
  const double reach = half * (1 + 1e-9);  // rounding must not lose a source on the border of two leaves
  const Point center{box.lo.x + half, box.lo.y + half}, a = source.a - center, b = source.b - center;
  if (std::max(a.x, b.x) < -reach || std::min(a.x, b.x) > reach) return false;
  if (std::max(a.y, b.y) < -reach || std::min(a.y, b.y) > reach) return false;
  const Point d = b - a;
  return std::abs(cross(d, a)) <= reach * (std::abs(d.x) + std::abs(d.y));
}

void SizeTree::split(std::uint32_t id) {
  const auto below = static_cast<std::uint32_t>(nodes_.size());
  nodes_[id].below = below;
  const Node parent = nodes_[id];
  const std::uint32_t half = width(parent) / 2;
  for (std::uint32_t k = 0; k < 4; ++k) {
    Node child = parent;
    child.below = 0;
    child.x += (k & 1) * half;
    child.y += (k >> 1) * half;
    ++child.depth;
    nodes_.push_back(child);
  }
}

/// Level by level, so that a tree that reaches the limit of nodes is too coarse evenly.
void SizeTree::refine(const std::function<double(Point)>& asked_at) {
  std::size_t n_bent = 0;
  struct Pending {
    std::uint32_t node, first, last;  ///< range of the sources that touch it
  };
  std::vector<std::uint32_t> pool(sources_.size()), next_pool;
  for (std::uint32_t i = 0; i < pool.size(); ++i) pool[i] = i;
  nodes_.push_back({});
  std::vector<Pending> level{{0, 0, static_cast<std::uint32_t>(pool.size())}}, next;
  for (; !level.empty(); std::swap(level, next), std::swap(pool, next_pool)) {
    next.clear();
    next_pool.clear();
    for (const Pending& p : level) {
      Node& node = nodes_[p.node];
      double asked = kNone;
      node.is_border = false;
      for (std::uint32_t i = p.first; i < p.last; ++i) {
        asked = std::min(asked, sources_[pool[i]].size);
        node.is_border |= sources_[pool[i]].is_border;
      }
      const double side = std::ldexp(side_, -node.depth);
      const bool can_split = node.depth < SizeField::kMaxDepth && nodes_.size() < kMaxNodes;
      const bool is_bent_only = can_split && side <= kLeafShare * asked && asked_at && is_bent(node, asked_at);
      if (is_bent_only && ++n_bent > kMaxBent) {
        const Box box = box_of(node);
        throw InputError(
            ErrorCode::InvalidOption,
            "Options::size_at jumps from place to place: expected lengths that change little over one of them",
            Where{{}, {}, inside_box(midpoint(box.lo, box.hi))});
      }
      if (!can_split || (side <= kLeafShare * asked && !is_bent_only)) {
        node.first = static_cast<std::uint32_t>(touching_.size());
        touching_.insert(touching_.end(), pool.begin() + p.first, pool.begin() + p.last);
        node.last = static_cast<std::uint32_t>(touching_.size());
        continue;
      }
      split(p.node);
      for (std::uint32_t k = 0; k < 4; ++k) {
        const std::uint32_t child = nodes_[p.node].below + k;
        const auto first = static_cast<std::uint32_t>(next_pool.size());
        for (std::uint32_t i = p.first; i < p.last; ++i)
          if (touches(sources_[pool[i]], nodes_[child])) next_pool.push_back(pool[i]);
        next.push_back({child, first, static_cast<std::uint32_t>(next_pool.size())});
      }
    }
  }
}

Point SizeTree::inside_box(Point p) const {
  return {std::clamp(p.x, box_.lo.x, box_.hi.x), std::clamp(p.y, box_.lo.y, box_.hi.y)};
}

/// The size function at middles of sides and centre is not what the corners tell of it; or the leaf is so large that
/// these few places tell nothing. Never where the leaf is smaller than the sizes in it.
bool SizeTree::is_bent(const Node& node, const std::function<double(Point)>& asked_at) const {
  const Box box = box_of(node);
  const double half = 0.5 * (box.hi.x - box.lo.x);
  std::array<double, 9> h;
  for (int k = 0; k < 9; ++k) {
    const int column = k % 3, row = k / 3;
    h[k] = asked_at(inside_box({box.lo.x + column * half, box.lo.y + row * half}));
  }
  const double least = *std::min_element(h.begin(), h.end());
  if (2 * half <= kLeafShare * least) return false;
  if (node.depth < kLeastDepth) return true;
  const double off = std::max({std::abs(h[1] - 0.5 * (h[0] + h[2])), std::abs(h[3] - 0.5 * (h[0] + h[6])),
                               std::abs(h[5] - 0.5 * (h[2] + h[8])), std::abs(h[7] - 0.5 * (h[6] + h[8])),
                               std::abs(h[4] - 0.25 * ((h[0] + h[8]) + (h[2] + h[6])))});
  return off > kBend * least;
}

void SizeTree::take_asked(const std::function<double(Point)>& asked_at) {
  for (std::uint32_t c = 0; c < corner_key_.size(); ++c) {
    corner_asked_.push_back(asked_at(inside_box(place(c))));
    corner_base_[c] = std::min(corner_base_[c], corner_asked_[c]);
  }
}

double SizeTree::quads(const std::vector<double>& sizes, const std::function<bool(Point)>& is_inside) const {
  double sum = 0;
  for (std::uint32_t i = 0; i < leaves_.size(); ++i) {
    const Box box = box_of(nodes_[leaves_[i]]);
    const Point lo = inside_box(box.lo), hi = inside_box(box.hi);
    const double area = (hi.x - lo.x) * (hi.y - lo.y);
    if (!(area > 0) || !is_inside(midpoint(lo, hi))) continue;
    double h = 0;
    for (std::uint32_t k = 0; k < 4; ++k) h += 0.25 * sizes[leaf_corners_[4 * i + k]];
    sum += area / (h * h);
  }
  return sum;
}

std::uint32_t SizeTree::leaf_at(std::uint32_t x, std::uint32_t y) const {
  std::uint32_t id = 0;
  for (int bit = SizeField::kMaxDepth - 1; nodes_[id].below; --bit)
    id = nodes_[id].below + ((x >> bit) & 1) + 2 * ((y >> bit) & 1);
  return id;
}

/// Leaves that share a part of a side differ by at most a factor two: they share a corner then.
void SizeTree::balance() {
  std::vector<std::uint32_t> pending;
  for (std::uint32_t i = 0; i < nodes_.size(); ++i)
    if (!nodes_[i].below) pending.push_back(i);
  for (std::size_t i = 0; i < pending.size(); ++i) {
    const Node node = nodes_[pending[i]];
    if (node.below || node.depth < 2) continue;
    const std::int64_t w = width(node), x = node.x, y = node.y;
    const std::pair<std::int64_t, std::int64_t> beside[] = {{x - 1, y}, {x + w, y}, {x, y - 1}, {x, y + w}};
    for (const auto& [bx, by] : beside) {
      if (bx < 0 || by < 0 || bx >= SizeField::kLattice || by >= SizeField::kLattice) continue;
      const auto px = static_cast<std::uint32_t>(bx), py = static_cast<std::uint32_t>(by);
      for (std::uint32_t leaf = leaf_at(px, py); nodes_[leaf].depth + 1 < node.depth; leaf = leaf_at(px, py)) {
        split(leaf);
        for (std::uint32_t k = 0; k < 4; ++k) pending.push_back(nodes_[leaf].below + k);
      }
    }
  }
}

void SizeTree::number_corners() {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> entries;
  entries.reserve(4 * leaves_.size());
  for (std::uint32_t i = 0; i < leaves_.size(); ++i) {
    const Node& node = nodes_[leaves_[i]];
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint64_t x = node.x + (k & 1) * width(node), y = node.y + (k >> 1) * width(node);
      entries.push_back({y << 32 | x, 4 * i + k});
    }
  }
  std::sort(entries.begin(), entries.end());
  leaf_corners_.resize(entries.size());
  corner_slots_.reserve(entries.size());
  for (const auto& [key, slot] : entries) {
    if (corner_key_.empty() || corner_key_.back() != key) {
      corner_key_.push_back(key);
      corner_start_.push_back(static_cast<std::uint32_t>(corner_slots_.size()));
    }
    leaf_corners_[slot] = static_cast<std::uint32_t>(corner_key_.size() - 1);
    corner_slots_.push_back(slot);
  }
  corner_start_.push_back(static_cast<std::uint32_t>(corner_slots_.size()));
}

/// Leaves without a border take the base size of their cell; those that share a corner lie in the same cell, so one
/// question answers for all that hang together. In leaves with a border the lesser side holds.
void SizeTree::fill_base(const std::function<double(Point)>& base_at) {
  corner_base_.assign(corner_key_.size(), kNone);
  std::vector<char> is_seen(leaves_.size(), 0);
  std::vector<std::uint32_t> pending;
  for (std::uint32_t seed = 0; seed < leaves_.size(); ++seed) {
    if (is_seen[seed]) continue;
    const Node& first = nodes_[leaves_[seed]];
    double base = kNone;
    if (first.is_border) {
      for (std::uint32_t i = first.first; i < first.last; ++i)
        if (sources_[touching_[i]].is_border) base = std::min(base, sources_[touching_[i]].size);
    } else {
      base = base_at(midpoint(box_of(first).lo, box_of(first).hi));
    }
    pending.assign(1, seed);
    is_seen[seed] = 1;
    while (!pending.empty()) {
      const std::uint32_t leaf = pending.back();
      pending.pop_back();
      for (std::uint32_t k = 0; k < 4; ++k) {
        const std::uint32_t corner = leaf_corners_[4 * leaf + k];
        corner_base_[corner] = std::min(corner_base_[corner], base);
        if (first.is_border) continue;
        for (std::uint32_t s = corner_start_[corner]; s < corner_start_[corner + 1]; ++s) {
          const std::uint32_t other = corner_slots_[s] / 4;
          if (is_seen[other] || nodes_[leaves_[other]].is_border) continue;
          is_seen[other] = 1;
          pending.push_back(other);
        }
      }
    }
  }
}

Point SizeTree::place(std::uint32_t corner) const {
  const double unit = side_ / SizeField::kLattice;
  const auto x = static_cast<std::uint32_t>(corner_key_[corner]),
             y = static_cast<std::uint32_t>(corner_key_[corner] >> 32);
  return {origin_.x + unit * x, origin_.y + unit * y};
}

/// The size that is allowed at a corner by a source, or beyond those, by a corner with the base size of its cell.
double SizeTree::offer(std::uint32_t from, std::uint32_t corner, double slope) const {
  const Point p = place(corner);
  if (from >= sources_.size()) {
    const auto other = static_cast<std::uint32_t>(from - sources_.size());
    return corner_base_[other] + slope * distance(p, place(other));
  }
  const SizeSource& source = sources_[from];
  const Point d = source.b - source.a;
  const double whole = norm2(d), t = whole > 0 ? std::clamp(dot(p - source.a, d) / whole, 0.0, 1.0) : 0;
  return source.size + slope * distance(p, source.a + t * d);
}

void SizeTree::grade(double slope) {
  corner_size_.assign(corner_key_.size(), kNone);
  std::vector<std::uint32_t> nearest(corner_key_.size());
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto hear = [&](std::uint32_t who, std::uint32_t corner) {
    const double size = offer(who, corner, slope);
    if (size >= corner_size_[corner]) return;
    corner_size_[corner] = size;
    nearest[corner] = who;
    queue.push({size, corner});
  };
  for (std::uint32_t c = 0; c < corner_key_.size(); ++c)
    if (corner_base_[c] < kNone) hear(static_cast<std::uint32_t>(sources_.size()) + c, c);
  for (std::uint32_t leaf = 0; leaf < leaves_.size(); ++leaf)
    for (std::uint32_t i = nodes_[leaves_[leaf]].first; i < nodes_[leaves_[leaf]].last; ++i)
      for (std::uint32_t k = 0; k < 4; ++k) hear(touching_[i], leaf_corners_[4 * leaf + k]);
  while (!queue.empty()) {
    const auto [size, corner] = queue.top();
    queue.pop();
    if (size > corner_size_[corner]) continue;
    for (std::uint32_t s = corner_start_[corner]; s < corner_start_[corner + 1]; ++s)
      for (std::uint32_t k = 0; k < 4; ++k) hear(nearest[corner], leaf_corners_[(corner_slots_[s] & ~3u) + k]);
  }
}

const double* SizeTree::corner_at(std::uint64_t x, std::uint64_t y) const {
  const std::uint64_t key = y << 32 | x;
  const auto found = std::lower_bound(corner_key_.begin(), corner_key_.end(), key);
  if (found == corner_key_.end() || *found != key) return nullptr;
  return &corner_size_[static_cast<std::size_t>(found - corner_key_.begin())];
}

/// The 3 x 3 sizes at corners, middles of sides and centre of a leaf; false where no smaller leaf lies beside it.
bool SizeTree::halves(std::uint32_t leaf, std::array<double, 9>& h) const {
  const Node& node = nodes_[leaves_[leaf]];
  const std::uint64_t w = width(node) / 2;
  if (w == 0) return false;
  for (std::uint32_t k = 0; k < 4; ++k) h[2 * (k & 1) + 6 * (k >> 1)] = corner_size_[leaf_corners_[4 * leaf + k]];
  bool has_middle = false;
  for (std::uint32_t k : {1u, 3u, 5u, 7u}) {
    const double* middle = corner_at(node.x + (k % 3) * w, node.y + (k / 3) * w);
    const bool is_level = k == 1 || k == 7;
    h[k] = middle ? *middle : 0.5 * (is_level ? h[k - 1] + h[k + 1] : h[k - 3] + h[k + 3]);
    has_middle |= middle != nullptr;
  }
  h[4] = 0.25 * ((h[0] + h[8]) + (h[2] + h[6]));
  return has_middle;
}

/// A leaf beside smaller ones is written as four, so that the sizes are continuous across its sides.
void SizeTree::write(SizeField& field) const {
  field.origin_ = origin_;
  field.per_side_ = 1 / side_;
  field.nodes_.resize(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) field.nodes_[i] = nodes_[i].below;
  const auto write_leaf = [&](double a, double b, double c, double d) {
    QUADLINE_CHECK(std::min({a, b, c, d}) > 0 && std::max({a, b, c, d}) < kNone);
    field.corners_.push_back({a, b, c, d});
    return SizeField::kLeaf | static_cast<std::uint32_t>(field.corners_.size() - 1);
  };
  std::array<double, 9> h;
  for (std::uint32_t i = 0; i < leaves_.size(); ++i) {
    if (halves(i, h)) {
      field.nodes_[leaves_[i]] = static_cast<std::uint32_t>(field.nodes_.size());
      for (std::uint32_t k : {0u, 1u, 3u, 4u}) field.nodes_.push_back(write_leaf(h[k], h[k + 1], h[k + 3], h[k + 4]));
    } else {
      const std::uint32_t* c = &leaf_corners_[4 * i];
      field.nodes_[leaves_[i]] =
          write_leaf(corner_size_[c[0]], corner_size_[c[1]], corner_size_[c[2]], corner_size_[c[3]]);
    }
  }
}

}  // namespace quadline
