#include "cells/cell_cache.hpp"

#include <bit>

namespace quadline {

std::uint64_t fingerprint(const WorkMesh& mesh) {
  std::uint64_t sum = 0;
  const auto add = [&](double x) {
    constexpr std::uint64_t kOdd = 0x9E3779B97F4A7C15;  // 2^64 / golden ratio: spreads over all bits
    sum = std::rotl((sum ^ std::bit_cast<std::uint64_t>(x)) * kOdd, 29);
  };
  for (const FaceId f : mesh.topo().faces()) {
    const Polygon p = mesh.topo().polygon(f);
    for (const NodeId v : p.corners()) {
      add(mesh.point(v).x);
      add(mesh.point(v).y);
    }
  }
  return sum;
}

}  // namespace quadline
