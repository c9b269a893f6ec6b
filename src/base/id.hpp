#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace quadline {

/// A typed index. Ids of different kinds do not compare or convert.
template <class Tag>
struct Id {
  std::uint32_t value = UINT32_MAX;  ///< UINT32_MAX: no element

  constexpr Id() = default;
  constexpr explicit Id(std::size_t i) : value(static_cast<std::uint32_t>(i)) {}
  constexpr bool valid() const { return value != UINT32_MAX; }
  friend constexpr auto operator<=>(Id, Id) = default;
};

/// A vector that takes nothing but its own kind of id.
template <class IdType, class T>
class IdVector {
 public:
  IdVector() = default;
  explicit IdVector(std::size_t n, const T& value = {}) : items_(n, value) {}

  decltype(auto) operator[](IdType id) { return items_[id.value]; }
  decltype(auto) operator[](IdType id) const { return items_[id.value]; }

  IdType push_back(T value) {
    items_.push_back(std::move(value));
    return IdType(items_.size() - 1);
  }
  /// Grows to `n` elements, never shrinks.
  void grow(std::size_t n, const T& value = {}) {
    if (items_.size() < n) items_.resize(n, value);
  }
  void assign(std::size_t n, const T& value) { items_.assign(n, value); }
  void reserve(std::size_t n) { items_.reserve(n); }
  void clear() { items_.clear(); }
  std::size_t count() const { return items_.size(); }
  bool empty() const { return items_.empty(); }
  IdType end_id() const { return IdType(items_.size()); }

  auto begin() { return items_.begin(); }
  auto end() { return items_.end(); }
  auto begin() const { return items_.begin(); }
  auto end() const { return items_.end(); }
  std::vector<T>& raw() { return items_; }
  const std::vector<T>& raw() const { return items_; }

 private:
  std::vector<T> items_;
};

// The mesh (topo, mesh)
using NodeId = Id<struct NodeIdTag>;
using HalfId = Id<struct HalfIdTag>;  ///< a half-edge: an edge seen from the face on its left
using EdgeId = Id<struct EdgeIdTag>;
using FaceId = Id<struct FaceIdTag>;

// The planar arrangement (domain)
using VertexId = Id<struct VertexIdTag>;  ///< a point that must be a mesh node
using CurveId = Id<struct CurveIdTag>;    ///< a piece of curve between two vertices
using CellId = Id<struct CellIdTag>;      ///< a piece of the domain between the curves

}  // namespace quadline
