#include "stages/qmorph/sleeping_sides.hpp"

namespace quadline {

SleepingSides::SleepingSides(const WorkMesh& mesh) : mesh_(mesh) {
  for (const Segment& s : mesh.segments()) {
    const HalfId first = mesh.topo().find(s.a, s.b);
    if (!first.valid() || mesh.is_boundary(edge_of(first))) continue;
    lines_[s.curve].second_side.push_back({s.b, s.a});
    line_of_[{s.b, s.a}] = s.curve;
  }
}

std::vector<HalfId> SleepingSides::wake_if_due(HalfId h) {
  Line& line = lines_[line_of_.at(ends_of(h))];
  const std::size_t n = line.second_side.size();
  while (line.n_meshed < n && !mesh_.is_triangle(twin(half(line.second_side[line.n_meshed])))) ++line.n_meshed;
  std::vector<HalfId> woken;
  if (line.n_meshed < n) return woken;
  for (const Ends& ends : line.second_side) {
    woken.push_back(half(ends));
    line_of_.erase(ends);
  }
  return woken;
}

std::vector<HalfId> SleepingSides::wake_all() {
  std::vector<HalfId> woken;
  for (const auto& [ends, line] : line_of_) woken.push_back(half(ends));
  line_of_.clear();
  return woken;
}

}  // namespace quadline
