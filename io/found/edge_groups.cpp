#include "io/found/edge_groups.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace quadline {
namespace {

struct Use {
  std::array<NodeIndex, 2> key;  ///< the smaller node first
  std::uint32_t curve;
  std::uint32_t place;  ///< index of the edge in its curve

  friend auto operator<=>(const Use&, const Use&) = default;
};

}  // namespace

std::vector<EdgeGroup> edge_groups(const Mesh& mesh, bool lines_only) {
  std::vector<Use> uses;
  for (std::uint32_t c = 0; c < mesh.curves.size(); ++c) {
    const EdgeSet& curve = mesh.curves[c];
    if (lines_only && curve.kind != CurveKind::Line) continue;
    for (std::uint32_t i = 0; i < curve.edges.size(); ++i) {
      const auto [a, b] = curve.edges[i];
      uses.push_back({{std::min(a, b), std::max(a, b)}, c, i});
    }
  }
  std::sort(uses.begin(), uses.end());

  // The first use of each edge stands for it; its set of curves is numbered.
  std::map<std::vector<std::uint32_t>, std::uint32_t> number_of_set;
  struct First {
    std::uint32_t curve, place, set;
  };
  std::vector<First> firsts;
  for (std::size_t i = 0; i < uses.size();) {
    std::vector<std::uint32_t> curves;
    const Use& first = uses[i];
    for (; i < uses.size() && uses[i].key == first.key; ++i)
      if (curves.empty() || curves.back() != uses[i].curve) curves.push_back(uses[i].curve);
    const auto next = static_cast<std::uint32_t>(number_of_set.size());
    const auto set = number_of_set.try_emplace(std::move(curves), next).first->second;
    firsts.push_back({first.curve, first.place, set});
  }
  std::sort(firsts.begin(), firsts.end(),
            [](const First& a, const First& b) { return std::pair(a.curve, a.place) < std::pair(b.curve, b.place); });

  std::vector<const std::vector<std::uint32_t>*> curves_of_set(number_of_set.size());
  for (const auto& [curves, set] : number_of_set) curves_of_set[set] = &curves;
  std::vector<EdgeGroup> groups;
  std::vector<std::size_t> group_of_set(number_of_set.size(), SIZE_MAX);
  for (const First& first : firsts) {
    if (group_of_set[first.set] == SIZE_MAX) {
      group_of_set[first.set] = groups.size();
      groups.push_back({*curves_of_set[first.set], {}});
    }
    groups[group_of_set[first.set]].edges.push_back(mesh.curves[first.curve].edges[first.place]);
  }
  return groups;
}

}  // namespace quadline
