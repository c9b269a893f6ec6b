// Patches with three, four or five corners have a filling with one irregular node at most where the lengths of the
// sides allow it [Bunin2006, Takayama2014]; a cut from side to side makes two such patches of many others. With s(i)
// the sides and t(i) the rows between the irregular node and side i, s(i) = t(i-1) + t(i+1).
#include "stages/cleanup/fill_patch.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace quadline::cleanup {

namespace {

constexpr std::size_t kMostCorners = 5;  // of a patch with one irregular node
constexpr std::size_t kMostCut = 6;      // of a patch that is cut in two
constexpr double kMostStrain = 3;

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

using Numbers = std::array<int, kMostCorners>;

// Rows between the irregular node and each of n = 3 or 5 sides, all >= 1; or equal opposite sides of four corners.
// Where the last side is a cut the irregular node may lie on it.
bool solve_rows(const Numbers& sides, std::size_t n, bool is_cut, Numbers& rows) {
  if (n == 4) return sides[0] == sides[2] && sides[1] == sides[3];
  if (n != 3 && n != 5) return false;
  for (std::size_t k = 0; k < n; ++k) {
    int sum = 0;
    for (std::size_t step = 0, i = k + 1; step < n; ++step, i += 2) sum += (step % 2 == 0 ? 1 : -1) * sides[i % n];
    if (sum < (is_cut && k + 1 == n ? 0 : 2) || sum % 2 != 0) return false;
    rows[k] = sum / 2;
  }
  return true;
}

// A patch while it is planned: its sides follow each other along the rim from `from`; the last one may be a cut.
struct Piece {
  std::size_t n = 0, from = 0;
  bool is_cut = false;
  Numbers sides{}, rows{};

  void add(int side) {
    if (n < kMostCorners) sides[n] = side;
    ++n;
  }
  bool solve() { return n <= kMostCorners && solve_rows(sides, n, is_cut, rows); }
};

// 0 where edges have their target length; about the square of the logarithm of their ratio, without libm.
double stretch(double length, double target) { return length / target + target / length - 2; }

class Filler {
 public:
  explicit Filler(std::span<const PatchNode> rim) : rim_(rim) {
    double size = 0;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      size += rim[i].size;
      if (rim[i].is_corner) corners_.push_back(i);
    }
    size_ = size / static_cast<double>(rim.size());
  }

  std::vector<Filling> run(std::size_t most, int most_irregular);

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
  Piece piece(std::size_t from, std::size_t to) const;
  Outline outline_of_piece(std::size_t from, std::size_t to, const Chain& cut) const;
  Point point_on(const Piece& piece, std::size_t side, double offset) const;
  double strain(const Piece& piece) const;
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
  std::vector<std::size_t> corners_;  // places on the rim
  double size_;
  std::vector<Plan> plans_;
};

Outline Filler::outline() const {
  Outline o;
  for (std::size_t i = 0; i < rim_.size(); ++i) o.nodes.push_back(static_cast<std::uint16_t>(i));
  o.corners = corners_;
  return o;
}

// The part of the rim from one end of a cut to the other, and back along the cut (given from `from` to `to`).
Outline Filler::outline_of_piece(std::size_t from, std::size_t to, const Chain& cut) const {
  Outline o;
  for (std::size_t p = from; p <= to; ++p) {
    const std::size_t i = p % rim_.size();
    if (p == from || p == to || rim_[i].is_corner) o.corners.push_back(o.nodes.size());
    o.nodes.push_back(static_cast<std::uint16_t>(i));
  }
  o.nodes.insert(o.nodes.end(), cut.rbegin() + 1, cut.rend() - 1);
  return o;
}

// The sides between the places `from` and `to` of the rim; the cut is still missing.
Piece Filler::piece(std::size_t from, std::size_t to) const {
  Piece piece;
  piece.from = from;
  piece.is_cut = true;
  std::size_t last = from;
  for (std::size_t turn = 0; turn < 2; ++turn) {
    for (const std::size_t corner : corners_) {
      const std::size_t p = corner + turn * rim_.size();
      if (p <= from || p >= to) continue;
      piece.add(static_cast<int>(p - last));
      last = p;
    }
  }
  piece.add(static_cast<int>(to - last));
  return piece;
}

Point Filler::point_on(const Piece& piece, std::size_t side, double offset) const {
  std::size_t start = piece.from;
  for (std::size_t i = 0; i < side; ++i) start += static_cast<std::size_t>(piece.sides[i]);
  if (piece.is_cut && side + 1 == piece.n) {  // straight, from the end of the piece of rim to its start
    const Point a = rim_[start % rim_.size()].at, b = rim_[piece.from % rim_.size()].at;
    return a + (offset / piece.sides[side]) * (b - a);
  }
  const auto down = static_cast<std::size_t>(offset);
  return midpoint(rim_[(start + down) % rim_.size()].at,
                  rim_[(start + static_cast<std::size_t>(std::ceil(offset))) % rim_.size()].at);
}

// Sum of the stretch along the spokes from the irregular node to the sides.
double Filler::strain(const Piece& piece) const {
  double sum = 0;
  const auto add = [&](Point a, Point b, int rows) {
    if (rows == 0) return;
    sum += stretch(distance(a, b), size_ * rows);
  };
  if (piece.n == 4) {
    const auto middle = [&](std::size_t side) { return point_on(piece, side, 0.5 * piece.sides[side]); };
    add(middle(0), middle(2), piece.sides[1]);
    add(middle(1), middle(3), piece.sides[0]);
    return sum;
  }
  std::array<Point, kMostCorners> foot;
  Point center;
  for (std::size_t i = 0; i < piece.n; ++i) {
    foot[i] = point_on(piece, i, piece.rows[(i + piece.n - 1) % piece.n]);
    center += (1.0 / static_cast<double>(piece.n)) * foot[i];
  }
  for (std::size_t i = 0; i < piece.n; ++i) add(center, foot[i], piece.rows[i]);
  return sum;
}

void Filler::plan_cuts() {
  const std::size_t n = rim_.size();
  for (std::size_t from = 0; from < n; ++from)
    for (std::size_t to = from + 2; to < n; ++to)
      if (!rim_[from].is_corner && !rim_[to].is_corner) plan_cut(from, to);
}

void Filler::plan_cut(std::size_t from, std::size_t to) {
  Piece one = piece(from, to), two = piece(to, from + rim_.size());
  if (one.n < 2 || two.n < 2 || one.n >= kMostCorners || two.n >= kMostCorners) return;
  const double wanted = distance(rim_[from].at, rim_[to].at) / size_;
  const int shortest = std::max(1, static_cast<int>(std::ceil(0.6 * wanted)));
  const int longest = std::max(1, static_cast<int>(1.6 * wanted));
  const std::size_t n_one = one.n, n_two = two.n;
  for (int length = shortest; length <= longest; ++length) {
    if ((static_cast<int>(to - from) + length) % 2 != 0) continue;
    one.n = n_one;
    two.n = n_two;
    one.add(length);
    two.add(length);
    if (!one.solve() || !two.solve()) continue;
    const double sum = strain(one) + strain(two) + stretch(wanted, length);
    if (sum > kMostStrain) continue;
    plans_.push_back({(one.n != 4) + (two.n != 4), sum, from, to, length});
  }
}

void Filler::fill_block(const Chain& bottom, const Chain& right, const Chain& top, const Chain& left,
                        Filling& filling) {
  const std::size_t nx = bottom.size() - 1, ny = right.size() - 1;
  std::vector<std::uint16_t> at((nx + 1) * (ny + 1));
  for (std::size_t j = 0; j <= ny; ++j) {
    for (std::size_t i = 0; i <= nx; ++i) {
      std::uint16_t& v = at[j * (nx + 1) + i];
      if (j == 0)
        v = bottom[i];
      else if (j == ny)
        v = top[i];
      else if (i == 0)
        v = left[j];
      else if (i == nx)
        v = right[j];
      else
        v = add_node(filling);
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
  Numbers sides{}, rows{};
  for (std::size_t i = 0; i < n; ++i) sides[i] = o.side_length(i);
  solve_rows(sides, n, true, rows);
  const std::size_t last = n - 1;
  std::array<std::size_t, kMostCorners> foot{};
  for (std::size_t i = 0; i < n; ++i) foot[i] = o.place(i) + static_cast<std::size_t>(rows[(i + n - 1) % n]);
  const bool on_cut = rows[last] == 0;
  const std::uint16_t center = on_cut ? o.node(foot[last]) : add_node(filling);
  std::array<Chain, kMostCorners> spoke;  // from the centre to the side
  for (std::size_t i = 0; i < n; ++i) {
    if (on_cut && i == last)
      spoke[i] = {center};
    else if (on_cut && i + 1 == last)
      spoke[i] = backwards(o.part(o.place(last), foot[last]));
    else if (on_cut && i == 0)
      spoke[i] = o.part(foot[last], o.place(n));
    else
      spoke[i] = add_chain(center, o.node(foot[i]), rows[i], filling);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = (i + 1) % n, corner = o.place(i + 1);
    const std::size_t end = k == 0 ? foot[0] + o.nodes.size() : foot[k];
    if (rows[i] > 0 && rows[k] > 0)
      fill_block(o.part(foot[i], corner), o.part(corner, end), spoke[k], backwards(spoke[i]), filling);
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
  const Chain cut =
      add_chain(static_cast<std::uint16_t>(plan.from), static_cast<std::uint16_t>(plan.to), plan.length, filling);
  fill(outline_of_piece(plan.from, plan.to, cut), filling);
  fill(outline_of_piece(plan.to, plan.from + rim_.size(), Chain(cut.rbegin(), cut.rend())), filling);
  return filling;
}

std::vector<Filling> Filler::run(std::size_t most, int most_irregular) {
  Piece whole;
  for (std::size_t i = 0; i < corners_.size(); ++i)
    whole.add(static_cast<int>((i + 1 < corners_.size() ? corners_[i + 1] : corners_[0] + rim_.size()) - corners_[i]));
  if (!corners_.empty()) whole.from = corners_[0];
  if (whole.solve()) {
    const double sum = strain(whole);
    if (sum <= kMostStrain && (whole.n != 4) <= most_irregular) plans_.push_back({whole.n != 4, sum, 0, 0, 0});
  } else if (corners_.size() >= 2 && corners_.size() <= kMostCut && most_irregular >= 2) {
    plan_cuts();
  }
  std::sort(plans_.begin(), plans_.end(), [](const Plan& a, const Plan& b) { return a.key() < b.key(); });
  std::vector<Filling> fillings;
  for (std::size_t i = 0; i < plans_.size() && i < most; ++i) fillings.push_back(build(plans_[i]));
  return fillings;
}

}  // namespace

std::vector<Filling> fill_patch(std::span<const PatchNode> rim, std::size_t most, int most_irregular) {
  return Filler(rim).run(most, most_irregular);
}

}  // namespace quadline::cleanup
