// Builds what plan_patch.cpp plans: blocks of rows, between the rim, the cut and the spokes of the irregular nodes.
#include "stages/cleanup/fill_patch.hpp"

#include "stages/cleanup/plan_patch.hpp"

namespace quadline::cleanup {

namespace {

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
    chain.reserve(to - from + 1);
    for (std::size_t p = from; p <= to; ++p) chain.push_back(node(p));
    return chain;
  }
};

class Filler {
 public:
  Filler(std::span<const PatchNode> rim, const PatchPlan& plan) : rim_(rim), plan_(plan) {}
  Filling run();

 private:
  Outline outline() const;
  Outline outline_of_piece(std::size_t from, std::size_t to, const Chain& cut) const;
  void fill(const Outline& o);
  void fill_block(const Chain& bottom, const Chain& right, const Chain& top, const Chain& left);
  std::uint16_t add_node() {
    return static_cast<std::uint16_t>(rim_.size() + static_cast<std::size_t>(filling_.n_inner++));
  }
  Chain add_chain(std::uint16_t from, std::uint16_t to, int length) {
    Chain chain;
    chain.reserve(static_cast<std::size_t>(length) + 1);
    chain.push_back(from);
    for (int i = 1; i < length; ++i) chain.push_back(add_node());
    chain.push_back(to);
    return chain;
  }

  std::span<const PatchNode> rim_;
  const PatchPlan& plan_;
  Filling filling_;
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

void Filler::fill_block(const Chain& bottom, const Chain& right, const Chain& top, const Chain& left) {
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
        v = add_node();
    }
  }
  for (std::size_t j = 0; j < ny; ++j)
    for (std::size_t i = 0; i < nx; ++i) {
      const std::size_t a = j * (nx + 1) + i;
      filling_.quads.push_back({at[a], at[a + 1], at[a + nx + 2], at[a + nx + 1]});
    }
}

void Filler::fill(const Outline& o) {
  const std::size_t n = o.side_count();
  const auto backwards = [](const Chain& c) { return Chain(c.rbegin(), c.rend()); };
  if (n == 4) {
    const auto side = [&](std::size_t i) { return o.part(o.place(i), o.place(i + 1)); };
    return fill_block(side(0), side(1), backwards(side(2)), backwards(side(3)));
  }
  Numbers sides{}, rows{};
  for (std::size_t i = 0; i < n; ++i) sides[i] = o.side_length(i);
  solve_rows(sides, n, true, rows);
  const std::size_t last = n - 1;
  std::array<std::size_t, kMostCorners> foot{};
  for (std::size_t i = 0; i < n; ++i) foot[i] = o.place(i) + static_cast<std::size_t>(rows[(i + n - 1) % n]);
  const bool on_cut = rows[last] == 0;
  const std::uint16_t center = on_cut ? o.node(foot[last]) : add_node();
  std::array<Chain, kMostCorners> spoke;  // from the centre to the side
  for (std::size_t i = 0; i < n; ++i) {
    if (on_cut && i == last)
      spoke[i] = {center};
    else if (on_cut && i + 1 == last)
      spoke[i] = backwards(o.part(o.place(last), foot[last]));
    else if (on_cut && i == 0)
      spoke[i] = o.part(foot[last], o.place(n));
    else
      spoke[i] = add_chain(center, o.node(foot[i]), rows[i]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = (i + 1) % n, corner = o.place(i + 1);
    const std::size_t end = k == 0 ? foot[0] + o.nodes.size() : foot[k];
    if (rows[i] > 0 && rows[k] > 0)
      fill_block(o.part(foot[i], corner), o.part(corner, end), spoke[k], backwards(spoke[i]));
  }
}

Filling Filler::run() {
  filling_.n_irregular = plan_.n_irregular;
  if (plan_.from == plan_.to) {
    fill(outline());
  } else {
    const Chain cut =
        add_chain(static_cast<std::uint16_t>(plan_.from), static_cast<std::uint16_t>(plan_.to), plan_.length);
    fill(outline_of_piece(plan_.from, plan_.to, cut));
    fill(outline_of_piece(plan_.to, plan_.from + rim_.size(), Chain(cut.rbegin(), cut.rend())));
  }
  return std::move(filling_);
}

}  // namespace

std::vector<Filling> fill_patch(std::span<const PatchNode> rim, std::size_t most, int most_irregular) {
  std::vector<Filling> fillings;
  for (const PatchPlan& plan : plan_patch(rim, most_irregular)) {
    if (fillings.size() == most) break;
    fillings.push_back(Filler(rim, plan).run());
  }
  return fillings;
}

}  // namespace quadline::cleanup
