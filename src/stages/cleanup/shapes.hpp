#pragma once

#include <span>
#include <vector>

#include "mesh/work_mesh.hpp"

namespace quadline::cleanup {

/// Sets of faces, one after the other.
class FaceSets {
 public:
  void clear() {
    faces_.clear();
    ends_.clear();
  }
  void begin() { start_ = faces_.size(); }
  void add(FaceId f);  ///< to the set begun last, unless it holds f
  void end() { ends_.push_back(faces_.size()); }
  void end_and_repeat();                  ///< ends the set, and begins the next with the same faces
  void drop() { faces_.resize(start_); }  ///< what was begun and not ended
  std::size_t count() const { return ends_.size(); }
  std::span<const FaceId> operator[](std::size_t i) const {
    const std::size_t from = i == 0 ? 0 : ends_[i - 1];
    return {faces_.data() + from, ends_[i] - from};
  }
  std::span<const FaceId> current() const { return {faces_.data() + start_, faces_.size() - start_}; }

 private:
  std::vector<FaceId> faces_;
  std::vector<std::size_t> ends_;
  std::size_t start_ = 0;
};

/// A kind of cavity that clean-up tries round a node.
struct Shape {
  const char* name;
  void (*propose)(const WorkMesh& mesh, NodeId v, FaceSets& sets);
};

/// From small to large.
std::span<const Shape> shapes();

}  // namespace quadline::cleanup
