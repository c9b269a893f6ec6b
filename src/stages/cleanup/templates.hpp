#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace quadline::cleanup {

/// A way to fill a disk with quads. Nodes 0 .. n_rim-1 are the rim, counter-clockwise, then come the inner ones.
struct Template {
  static constexpr int kMaxQuads = 9;
  std::uint8_t n_rim = 0, n_inner = 0, n_quads = 0;
  std::uint8_t inner_cost = 0;  ///< number of inner nodes without four quads
  std::array<std::array<std::uint8_t, 4>, kMaxQuads> quads{};
};

/// The quadrangulations of small disks with few inner nodes, of three to five quads each; made by recursion, found by
/// what they do to the rim.
///
/// Source: the cavities of [Reberol2021]; we differ: made at start in a millisecond instead of read from a file.
class TemplateTable {
 public:
  static constexpr int kMaxRim = 10;
  static constexpr int kMaxRimQuads = 4;
  /// Cost of giving a rim node 1 .. kMaxRimQuads quads (index 0 is not used).
  using RimCosts = std::array<int, kMaxRimQuads + 1>;
  struct Match {
    const Template* way = nullptr;
    int cost = 0;
  };

  TemplateTable();

  /// The `most` cheapest ways to fill a disk whose rim has costs.size() nodes (even), cost = rim + inner, below
  /// `limit`; cheapest first, then in the order of the table.
  void find(std::span<const RimCosts> costs, int limit, std::size_t most, std::vector<Match>& found) const;

  std::size_t count() const { return templates_.size(); }

 private:
  friend class TemplateMaker;
  struct Branch {
    std::array<std::uint32_t, kMaxRimQuads> child{};  // by the quads of the rim node, less one; 0: none
    std::uint32_t way = UINT32_MAX;                   // leaves: the first template; its like follow
    std::uint8_t n_ways = 0;
    std::uint8_t least_inner = UINT8_MAX;
  };
  void descend(std::span<const RimCosts> costs, std::size_t depth, std::uint32_t branch, int cost, int& limit,
               std::size_t most, std::vector<Match>& found) const;
  void file(const std::vector<Template>& ways);

  std::vector<Template> templates_;
  std::vector<Branch> branches_;
  std::array<std::uint32_t, kMaxRim + 1> root_{};  // by the length of the rim; 0: none
};

}  // namespace quadline::cleanup
