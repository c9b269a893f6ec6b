// Patches with three, four or five corners have a filling with one irregular node at most where the lengths of the
// sides allow it [Bunin2006, Takayama2014]; a cut from side to side makes two such patches of many others. With s(i)
// the sides and t(i) the rows between the irregular node and side i, s(i) = t(i-1) + t(i+1).
#include "stages/cleanup/plan_patch.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace quadline::cleanup {

namespace {

constexpr std::size_t kMostCut = 6;  // corners of a patch that is cut in two
constexpr double kMostStrain = 3;

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

class Planner {
 public:
  explicit Planner(std::span<const PatchNode> rim) : rim_(rim) {
    double size = 0;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      size += rim[i].size;
      if (rim[i].is_corner) corners_.push_back(i);
    }
    size_ = size / static_cast<double>(rim.size());
  }

  std::vector<PatchPlan> run(int most_irregular);

 private:
  Piece whole() const;
  Piece piece(std::size_t from, std::size_t to) const;
  void plan_cuts();
  void plan_cut(std::size_t from, std::size_t to);
  Point point_on(const Piece& piece, std::size_t side, double offset) const;
  double strain(const Piece& piece) const;

  std::span<const PatchNode> rim_;
  std::vector<std::size_t> corners_;  // places on the rim
  double size_;
  std::vector<PatchPlan> plans_;
};

Piece Planner::whole() const {
  Piece piece;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const std::size_t end = i + 1 < corners_.size() ? corners_[i + 1] : corners_[0] + rim_.size();
    piece.add(static_cast<int>(end - corners_[i]));
  }
  if (!corners_.empty()) piece.from = corners_[0];
  return piece;
}

// The sides between the places `from` and `to` of the rim; the cut is still missing.
Piece Planner::piece(std::size_t from, std::size_t to) const {
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

Point Planner::point_on(const Piece& piece, std::size_t side, double offset) const {
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
double Planner::strain(const Piece& piece) const {
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

void Planner::plan_cuts() {
  const std::size_t n = rim_.size();
  for (std::size_t from = 0; from < n; ++from)
    for (std::size_t to = from + 2; to < n; ++to)
      if (!rim_[from].is_corner && !rim_[to].is_corner) plan_cut(from, to);
}

void Planner::plan_cut(std::size_t from, std::size_t to) {
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

std::vector<PatchPlan> Planner::run(int most_irregular) {
  Piece all = whole();
  if (all.solve()) {
    const int n_irregular = all.n == 4 ? 0 : 1;
    const double sum = strain(all);
    if (sum <= kMostStrain && n_irregular <= most_irregular) plans_.push_back({n_irregular, sum, 0, 0, 0});
  } else if (corners_.size() >= 2 && corners_.size() <= kMostCut && most_irregular >= 2) {
    plan_cuts();
  }
  std::sort(plans_.begin(), plans_.end(), [](const PatchPlan& a, const PatchPlan& b) {
    return std::tie(a.n_irregular, a.strain, a.from, a.to, a.length) <
           std::tie(b.n_irregular, b.strain, b.from, b.to, b.length);
  });
  return std::move(plans_);
}

}  // namespace

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

std::vector<PatchPlan> plan_patch(std::span<const PatchNode> rim, int most_irregular) {
  return Planner(rim).run(most_irregular);
}

}  // namespace quadline::cleanup
