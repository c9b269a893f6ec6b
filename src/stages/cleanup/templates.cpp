// Small quadrangulations of a disk [Reberol2021]: the quad on the first side of an open polygon is chosen in all ways,
// and what remains is one to three smaller polygons; every quadrangulation comes out once for each rotation of its rim.
#include "stages/cleanup/templates.hpp"

#include <algorithm>
#include <initializer_list>
#include <tuple>

namespace quadline::cleanup {

namespace {

constexpr int kMostInnerQuads = 5;  // valences 3 to 5 inside
constexpr int kWaysPerRim = 2;      // templates kept of those that do the same to the rim
struct Family {
  int n_rim;
  int most_inner;
  int most_irregular;  // inner nodes of three or five quads
};
// All that differ in use, within a start-up of some milliseconds. One quad can only become five, round a smaller one.
constexpr std::array<Family, 4> kFamilies{{{4, 4, 4}, {6, 4, 3}, {8, 4, 2}, {10, 2, 2}}};

constexpr int kMostNodes = TemplateTable::kMaxRim + 4;

// A polygon that is still open.
struct Ring {
  int n = 0;
  std::array<std::uint8_t, kMostNodes> nodes{};
  void add(int v) { nodes[n++] = static_cast<std::uint8_t>(v); }
};

std::array<std::uint8_t, TemplateTable::kMaxRim> rim_quads(const Template& t) {
  std::array<std::uint8_t, TemplateTable::kMaxRim> n{};
  for (int q = 0; q < t.n_quads; ++q)
    for (const std::uint8_t v : t.quads[q])
      if (v < t.n_rim) ++n[v];
  return n;
}

}  // namespace

class TemplateMaker {
 public:
  explicit TemplateMaker(const Family& family) : n_rim_(family.n_rim), family_(family) {}

  std::vector<Template> make() {
    way_.n_rim = static_cast<std::uint8_t>(n_rim_);
    Ring rim;
    for (int i = 0; i < n_rim_; ++i) {
      rim.add(i);
      join(i, (i + 1) % n_rim_, true);
    }
    open_ = {rim};
    fill();
    return std::move(made_);
  }

 private:
  void join(int a, int b, bool on) { joined_[a][b] = joined_[b][a] = on; }
  int most_quads(int v) const { return v < n_rim_ ? TemplateTable::kMaxRimQuads : kMostInnerQuads; }

  void finish() {
    int irregular = 0;
    for (int v = n_rim_; v < n_rim_ + way_.n_inner; ++v) {
      if (quads_[v] < 3) return;
      irregular += quads_[v] != 4;
    }
    if (irregular > family_.most_irregular) return;
    way_.inner_cost = static_cast<std::uint8_t>(irregular);
    made_.push_back(way_);
  }

  // Fills what is open in all ways, and leaves everything as it found it.
  void fill() {
    if (open_.empty()) return finish();
    const Ring p = open_.back();
    open_.pop_back();
    // The quad on the side p0 p1 has the corners p0 p1 x y; each of x and y is a node of the polygon or a new one.
    for (int i = 2; i <= p.n; i += 2)                           // x = p[i]; n: new
      for (int j = i == p.n ? 3 : i + 1; j <= p.n + 1; j += 2)  // y = p[j]; n + 1: new
        choose(p, i, j == p.n + 1 ? p.n : j);
    open_.push_back(p);
  }

  void choose(const Ring& p, int i, int j) {
    const int n = p.n;
    const bool new_x = i == n, new_y = j == n;
    if (way_.n_inner + new_x + new_y > family_.most_inner || way_.n_quads == Template::kMaxQuads) return;
    const int fresh = n_rim_ + way_.n_inner;
    const int x = new_x ? fresh : p.nodes[i], y = new_y ? fresh + new_x : p.nodes[j];
    const int a = p.nodes[0], b = p.nodes[1];
    const bool make_bx = i != 2, make_ya = j != n - 1, make_xy = new_x || new_y || j != i + 1;
    if ((make_bx && joined_[b][x]) || (make_ya && joined_[y][a]) || (make_xy && joined_[x][y])) return;
    for (const int v : {a, b, x, y})
      if (quads_[v] == most_quads(v)) return;

    const std::size_t n_open = open_.size();
    // The pieces that the quad leaves: p[from .. to], closed by `extra` nodes.
    const auto leave = [&](int from, int to, std::initializer_list<int> extra) {
      if (to - from + 1 + static_cast<int>(extra.size()) < 4) return;
      Ring rest;
      for (int k = from; k <= to; ++k) rest.add(p.nodes[k == n ? 0 : k]);
      for (const int v : extra) rest.add(v);
      open_.push_back(rest);
    };
    if (new_x && new_y) {
      leave(1, n, {y, x});
    } else if (new_x) {
      leave(1, j, {x});
      leave(j, n, {});
    } else if (new_y) {
      leave(1, i, {});
      leave(i, n, {y});
    } else {
      leave(1, i, {});
      leave(i, j, {});
      leave(j, n, {});
    }
    const auto u8 = [](int v) { return static_cast<std::uint8_t>(v); };
    way_.quads[way_.n_quads++] = {u8(a), u8(b), u8(x), u8(y)};
    way_.n_inner = u8(way_.n_inner + new_x + new_y);
    for (const int v : {a, b, x, y}) ++quads_[v];
    if (make_bx) join(b, x, true);
    if (make_ya) join(y, a, true);
    if (make_xy) join(x, y, true);

    fill();

    if (make_bx) join(b, x, false);
    if (make_ya) join(y, a, false);
    if (make_xy) join(x, y, false);
    for (const int v : {a, b, x, y}) --quads_[v];
    way_.n_inner = u8(way_.n_inner - new_x - new_y);
    --way_.n_quads;
    open_.resize(n_open);
  }

  int n_rim_;
  Family family_;
  Template way_;
  std::array<int, kMostNodes> quads_{};
  std::array<std::array<bool, kMostNodes>, kMostNodes> joined_{};
  std::vector<Ring> open_;
  std::vector<Template> made_;
};

TemplateTable::TemplateTable() {
  branches_.push_back({});  // 0 means none
  for (const Family& family : kFamilies) {
    const std::vector<Template> ways = TemplateMaker(family).make();
    root_[family.n_rim] = static_cast<std::uint32_t>(branches_.size());
    branches_.push_back({});
    file(ways);
  }
}

void TemplateTable::file(const std::vector<Template>& ways) {
  struct Keyed {
    std::uint64_t rim;  // four bits for each node
    const Template* way;
  };
  std::vector<Keyed> sorted;
  for (const Template& t : ways) {
    Keyed keyed{0, &t};
    for (const std::uint8_t n : rim_quads(t)) keyed.rim = keyed.rim << 4 | n;
    sorted.push_back(keyed);
  }
  std::sort(sorted.begin(), sorted.end(), [](const Keyed& a, const Keyed& b) {
    if (a.rim != b.rim) return a.rim < b.rim;
    const Template &s = *a.way, &t = *b.way;
    return std::tie(s.inner_cost, s.n_quads, s.quads) < std::tie(t.inner_cost, t.n_quads, t.quads);
  });
  for (const Keyed& keyed : sorted) {
    const Template& t = *keyed.way;
    const auto rim = rim_quads(t);
    std::uint32_t at = root_[t.n_rim];
    for (int i = 0; i < t.n_rim; ++i) {
      branches_[at].least_inner = std::min(branches_[at].least_inner, t.inner_cost);
      std::uint32_t child = branches_[at].child[rim[i] - 1];
      if (child == 0) {
        child = static_cast<std::uint32_t>(branches_.size());
        branches_[at].child[rim[i] - 1] = child;
        branches_.push_back({});
      }
      at = child;
    }
    Branch& leaf = branches_[at];
    if (leaf.n_ways == kWaysPerRim) continue;
    if (leaf.n_ways++ == 0) leaf.way = static_cast<std::uint32_t>(templates_.size());
    leaf.least_inner = std::min(leaf.least_inner, t.inner_cost);
    templates_.push_back(t);
  }
}

void TemplateTable::find(std::span<const RimCosts> costs, int limit, std::size_t most,
                         std::vector<Match>& found) const {
  found.clear();
  if (costs.size() > kMaxRim || root_[costs.size()] == 0) return;
  descend(costs, 0, root_[costs.size()], 0, limit, most, found);
}

void TemplateTable::descend(std::span<const RimCosts> costs, std::size_t depth, std::uint32_t branch, int cost,
                            int& limit, std::size_t most, std::vector<Match>& found) const {
  const Branch& at = branches_[branch];
  if (cost + at.least_inner >= limit) return;
  if (depth < costs.size()) {
    for (int q = 1; q <= kMaxRimQuads; ++q)
      if (const std::uint32_t child = at.child[q - 1]; child != 0)
        descend(costs, depth + 1, child, cost + costs[depth][q], limit, most, found);
    return;
  }
  for (std::uint32_t i = at.way; i < at.way + at.n_ways; ++i) {
    const Match match{&templates_[i], cost + templates_[i].inner_cost};
    if (match.cost >= limit) continue;
    const auto place = std::upper_bound(found.begin(), found.end(), match,
                                        [](const Match& a, const Match& b) { return a.cost < b.cost; });
    found.insert(place, match);
    if (found.size() > most) found.pop_back();
    if (found.size() == most) limit = found.back().cost;
  }
}

}  // namespace quadline::cleanup
