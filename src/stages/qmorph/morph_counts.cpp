#include "quadline/report.hpp"

namespace quadline {

MorphCounts& MorphCounts::operator+=(const MorphCounts& other) {
  n_triangles += other.n_triangles;
  for (std::size_t tail = 0; tail < quads.size(); ++tail)
    for (std::size_t head = 0; head < quads[tail].size(); ++head) quads[tail][head] += other.quads[tail][head];
  side_neighbour += other.side_neighbour;
  side_chosen += other.side_chosen;
  side_swapped += other.side_swapped;
  side_split_parity += other.side_split_parity;
  side_split_length += other.side_split_length;
  side_split_direction += other.side_split_direction;
  top_found += other.top_found;
  top_swapped += other.top_swapped;
  seams += other.seams;
  transition_seams += other.transition_seams;
  transition_splits += other.transition_splits;
  closures_of_4 += other.closures_of_4;
  closures_of_6_by_2 += other.closures_of_6_by_2;
  closures_of_6_by_3 += other.closures_of_6_by_3;
  completion_triangles += other.completion_triangles;
  completion_quads += other.completion_quads;
  refused_side += other.refused_side;
  refused_top += other.refused_top;
  refused_shape += other.refused_shape;
  return *this;
}

}  // namespace quadline
