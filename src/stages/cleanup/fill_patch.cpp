// Patches with three, four or five corners have a filling with one irregular node at most where the lengths of the sides
// allow it [Bunin2006, Takayama2014]; a cut from side to side makes two such patches of many others. With s(i) the sides
// and t(i) the rows between the irregular node and side i, s(i) = t(i-1) + t(i+1).
#include "stages/cleanup/fill_patch.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace quadline::cleanup {

namespace {

constexpr std::size_t kMostCorners = 5;

using Chain = std::vector<std::uint16_t>;

// A closed polygon of nodes; corners by their places in it, the first corner first.
struct Outline {
  Chain nodes;
  std::vector<std::size_t> corners;

  std::size_t side_count() const { return corners.size(); }
  std::size_t place(std::size_t corner) const {
    return corner < corners.size() ? corners[corner] : corners[corner - corners.size()] + nodes.size();
  }
  int side_length(std::size_t i) const { return static_cast<int>(place(i + 1) - place(i)); }
  std::uint16_t node(std::size_t p) const { return nodes[p % nodes.size()]; }
  Chain part(std::size_t from, std::size_t to) const {
    Chain chain;
    for (std::size_t p = from; p <= to; ++p) chain.push_back(node(p));
    return chain;
  }
};

// Rows between the irregular node and each side of a patch with three or five corners, all >= 1; or equal opposite
// sides of four corners.
bool solve_rows(const Outline& o, std::array<int, kMostCorners>& rows) {
  const std::size_t n = o.side_count();
  if (n == 4) return o.side_length(0) == o.side_length(2) && o.side_length(1) == o.side_length(3);
  if (n != 3 && n != 5) return false;
  for (std::size_t k = 0; k < n; ++k) {
    int sum = 0;
    for (std::size_t step = 0, i = k + 1; step < n; ++step, i += 2)
      sum += (step % 2 == 0 ? 1 : -1) * o.side_length(i % n);
    if (sum < 2 || sum % 2 != 0) return false;
    rows[k] = sum / 2;
  }
  return true;
}

class Filler {
 public:
  explicit Filler(std::span<const PatchNode> rim) : rim_(rim), points_(rim.size()) {
    double size = 0;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      points_[i] = rim[i].at;
      size += rim[i].size;
    }
    size_ = size / static_cast<double>(rim.size());
  }

  std::vector<Filling> run(std::size_t most);

 private:
  struct Plan {
    int n_irregular;
    double strain;
    std::size_t from, to;  // the cut, by places on the rim; equal: none
    int length;
    auto key() const { return std::make_tuple(n_irregular, strain, from, to, length); }
  };

  Outline outline() const;
  void plan_cuts();
  void plan_cut(std::size_t from, std::size_t to);
  Outline piece(std::size_t from, std::size_t to, const Chain& cut) const;
  double strain(const Outline& o, const std::array<int, kMostCorners>& rows) const;
  Filling build(const Plan& plan);
  void fill(const Outline& o, Filling& filling);
  void fill_block(const Chain& bottom, const Chain& right, const Chain& top, const Chain& left, Filling& filling);
  std::uint16_t add_node(Filling& filling) const {
    return static_cast<std::uint16_t>(rim_.size() + static_cast<std::size_t>(filling.n_inner++));
  }
  Chain add_chain(std::uint16_t from, std::uint16_t to, int length, Filling& filling) const {
    Chain chain{from};
    for (int i = 1; i < length; ++i) chain.push_back(add_node(filling));
    chain.push_back(to);
    return chain;
  }

  std::span<const PatchNode> rim_;
  std::vector<Point> points_;  // of the rim, then of the cut that is being planned
  double size_;
  std::vector<Plan> plans_;
};

Outline Filler::outline() const {
  Outline o;
  for (std::size_t i = 0; i < rim_.size(); ++i) {
    o.nodes.push_back(static_cast<std::uint16_t>(i));
    if (rim_[i].is_corner) o.corners.push_back(i);
  }
  return o;
}

// The part of the rim from one end of a cut to the other, and back along the cut (given from `from` to `to`).
Outline Filler::piece(std::size_t from, std::size_t to, const Chain& cut) const {
  Outline o;
  for (std::size_t p = from; p <= to; ++p) {
    const std::size_t i = p % rim_.size();
    if (p == from || p == to || rim_[i].is_corner) o.corners.push_back(o.nodes.size());
    o.nodes.push_back(static_cast<std::uint16_t>(i));
  }
  o.nodes.insert(o.nodes.end(), cut.rbegin() + 1, cut.rend() - 1);
  return o;
}

// Sum of the squared logarithms of edge over target length along the spokes from the irregular node to the sides.
double Filler::strain(const Outline& o, const std::array<int, kMostCorners>& rows) const {
  const std::size_t n = o.side_count();
  std::array<Point, kMostCorners> foot;
  Point center;
  double sum = 0;
  if (n == 4) {
    for (std::size_t i = 0; i < 2; ++i) {
      const auto middle = [&](std::size_t side) {
        const std::size_t a = o.place(side), b = o.place(side + 1);
        return midpoint(points_[o.node((a + b) / 2)], points_[o.node((a + b + 1) / 2)]);
      };
      const double ratio = distance(middle(i), middle(i + 2)) / (size_ * o.side_length(i + 1));
      sum += std::log(ratio) * std::log(ratio);
    }
    return sum;
  }
  for (std::size_t i = 0; i < n; ++i) {
    foot[i] = points_[o.node(o.place(i) + static_cast<std::size_t>(rows[(i + n - 1) % n]))];
    center += (1.0 / static_cast<double>(n)) * foot[i];
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double ratio = distance(center, foot[i]) / (size_ * rows[i]);
    sum += std::log(ratio) * std::log(ratio);
  }
  return sum;
}

void Filler::plan_cuts() {
  const std::size_t n = rim_.size();
  for (std::size_t from = 0; from < n; ++from)
    for (std::size_t to = from + 2; to < n; ++to)
      if (!rim_[from].is_corner && !rim_[to].is_corner) plan_cut(from, to);
}

void Filler::plan_cut(std::size_t from, std::size_t to) {
  const double wanted = distance(rim_[from].at, rim_[to].at) / size_;
  const int shortest = std::max(1, static_cast<int>(std::ceil(0.6 * wanted)));
  const int longest = std::max(1, static_cast<int>(1.6 * wanted));
  for (int length = shortest; length <= longest; ++length) {
    if ((static_cast<int>(to - from) + length) % 2 != 0) continue;
    Chain cut{static_cast<std::uint16_t>(from)};
    points_.resize(rim_.size());
    for (int i = 1; i < length; ++i) {
      cut.push_back(static_cast<std::uint16_t>(points_.size()));
      points_.push_back(rim_[from].at + (double(i) / length) * (rim_[to].at - rim_[from].at));
    }
    cut.push_back(static_cast<std::uint16_t>(to));
    const Outline one = piece(from, to, cut);
    const Outline two = piece(to, from + rim_.size(), Chain(cut.rbegin(), cut.rend()));
    std::array<int, kMostCorners> rows_one{}, rows_two{};
    if (!solve_rows(one, rows_one) || !solve_rows(two, rows_two)) continue;
    const double stretch = std::log(wanted / length);
    const int irregular = (one.side_count() != 4) + (two.side_count() != 4);
    plans_.push_back({irregular, strain(one, rows_one) + strain(two, rows_two) + stretch * stretch, from, to, length});
  }
}

void Filler::fill_block(const Chain& bottom, const Chain& right, const Chain& top, const Chain& left,
                        Filling& filling) {
  const std::size_t nx = bottom.size() - 1, ny = right.size() - 1;
  std::vector<std::uint16_t> at((nx + 1) * (ny + 1));
  for (std::size_t j = 0; j <= ny; ++j) {
    for (std::size_t i = 0; i <= nx; ++i) {
      std::uint16_t& v = at[j * (nx + 1) + i];
      if (j == 0) v = bottom[i];
      else if (j == ny) v = top[i];
      else if (i == 0) v = left[j];
      else if (i == nx) v = right[j];
      else v = add_node(filling);
    }
  }
  for (std::size_t j = 0; j < ny; ++j)
    for (std::size_t i = 0; i < nx; ++i) {
      const std::size_t a = j * (nx + 1) + i;
      filling.quads.push_back({at[a], at[a + 1], at[a + nx + 2], at[a + nx + 1]});
    }
}

void Filler::fill(const Outline& o, Filling& filling) {
  const std::size_t n = o.side_count();
  const auto backwards = [](const Chain& c) { return Chain(c.rbegin(), c.rend()); };
  if (n == 4) {
    const auto side = [&](std::size_t i) { return o.part(o.place(i), o.place(i + 1)); };
    return fill_block(side(0), side(1), backwards(side(2)), backwards(side(3)), filling);
  }
  std::array<int, kMostCorners> rows{};
  solve_rows(o, rows);
  const std::uint16_t center = add_node(filling);
  std::array<std::size_t, kMostCorners> foot{};
  std::array<Chain, kMostCorners> spoke;  // from the centre to the side
  for (std::size_t i = 0; i < n; ++i) {
    foot[i] = o.place(i) + static_cast<std::size_t>(rows[(i + n - 1) % n]);
    spoke[i] = add_chain(center, o.node(foot[i]), rows[i], filling);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = (i + 1) % n, corner = o.place(i + 1);
    const std::size_t end = k == 0 ? foot[0] + o.nodes.size() : foot[k];
    fill_block(o.part(foot[i], corner), o.part(corner, end), spoke[k], spoke[i], filling);
  }
}

Filling Filler::build(const Plan& plan) {
  Filling filling;
  filling.n_irregular = plan.n_irregular;
  filling.strain = plan.strain;
  if (plan.from == plan.to) {
    fill(outline(), filling);
    return filling;
  }
  const Chain cut = add_chain(static_cast<std::uint16_t>(plan.from), static_cast<std::uint16_t>(plan.to), plan.length, filling);
  fill(piece(plan.from, plan.to, cut), filling);
  fill(piece(plan.to, plan.from + rim_.size(), Chain(cut.rbegin(), cut.rend())), filling);
  return filling;
}

std::vector<Filling> Filler::run(std::size_t most) {
  const Outline whole = outline();
  std::array<int, kMostCorners> rows{};
  if (solve_rows(whole, rows)) {
    plans_.push_back({whole.side_count() != 4, strain(whole, rows), 0, 0, 0});
  } else {
    plan_cuts();
  }
  std::sort(plans_.begin(), plans_.end(), [](const Plan& a, const Plan& b) { return a.key() < b.key(); });
  std::vector<Filling> fillings;
  for (std::size_t i = 0; i < plans_.size() && i < most; ++i) fillings.push_back(build(plans_[i]));
  return fillings;
}

}  // namespace

std::vector<Filling> fill_patch(std::span<const PatchNode> rim, std::size_t most) { return Filler(rim).run(most); }

}  // namespace quadline::cleanup
