#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "quadline/errors.hpp"
#include "quadline/mesh.hpp"

namespace quadline {

/// A file that is read: its bytes, and errors that point into it.
struct SourceFile {
  std::string_view bytes;
  std::string name;

  [[noreturn]] void fail_at_line(std::size_t offset, const std::string& message) const;
  [[noreturn]] void fail_at_byte(std::size_t offset, const std::string& message) const;
  [[noreturn]] void fail(const std::string& message, ErrorCode code = ErrorCode::FileSyntax) const;
};

/// From the node or element numbers of a file to indices. Numbers may have gaps and any order.
class Numbering {
 public:
  /// Gives the next index to a number.
  void add(std::int64_t number) { entries_.emplace_back(number, static_cast<std::uint32_t>(entries_.size())); }
  /// Call once after the last `add`. Returns false where a number came twice.
  bool close();
  /// Index of a number, UINT32_MAX where there is none. O(log n), O(1) where the numbers count up without gaps.
  std::uint32_t find(std::int64_t number) const;
  std::size_t count() const { return entries_.size(); }
  /// After `close`: (number, index) by number.
  const std::vector<std::pair<std::int64_t, std::uint32_t>>& entries() const { return entries_; }

 private:
  std::vector<std::pair<std::int64_t, std::uint32_t>> entries_;
};

/// What a reader found, before it is known to be a plane mesh.
struct FoundMesh {
  Mesh mesh;
  std::vector<double> z;  ///< of every node
};

/// Puts the nodes into the order of their numbers. Returns false where a number came twice.
bool sort_nodes(Numbering& numbers, FoundMesh& found);

/// Makes a plane mesh of it: checks that it lies in a plane z = constant; turns the elements where it is seen from
/// below; puts the edges of curves into their order; finds the boundary loops among the curves, and among the node sets
/// that run round one.
/// @throws InputError  there is no quad or triangle, or it does not lie in a plane z = constant.
Mesh plane_mesh(FoundMesh found, const SourceFile& file);

}  // namespace quadline
