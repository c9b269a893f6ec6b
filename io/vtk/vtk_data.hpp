#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/found/found_mesh.hpp"

namespace quadline {

/// The types of cells that a plane mesh of first order has.
enum VtkCell : std::uint8_t { kVtkVertex = 1, kVtkLine = 3, kVtkTriangle = 5, kVtkQuad = 9 };

/// How a VTK XML file stores its binary arrays.
struct VtkEncoding {
  bool wide_headers = false;  ///< counts of 8 bytes, not of 4
  bool swapped = false;       ///< the byte order is not the machine's
  bool compressed = false;    ///< blocks of zlib streams
};

/// The bytes of a binary array: counts, then data, as VTK lays them out [VTKFormats].
///
/// @param text       starts with the array; may go on behind it.
/// @param is_base64  the array is base64 text, not raw bytes.
/// @param most       bytes that it may take.
/// @param at         where the array stands in the file, for errors.
/// @throws InputError  it ends too early, or claims more bytes than its text can hold, or than `most`.
std::string vtk_binary(std::string_view text, bool is_base64, const VtkEncoding& encoding, std::size_t most,
                       const SourceFile& file, std::size_t at);

/// The values of an array of VTK type `type` ("Float64", "Int32", ...), as numbers of type T.
template <class T>
std::vector<T> vtk_values(std::string_view bytes, std::string_view type, bool swapped, const SourceFile& file,
                          std::size_t at);

/// A cell as VTK files give it.
struct VtkCellNodes {
  std::int64_t type;
  const std::int64_t* nodes;  ///< indices into the points of its piece
  std::size_t n_nodes;
};

/// Its nodes as indices into all points, of which `first` of those before and `count` of its piece are there.
/// @throws InputError  it is of another type, or its nodes are not there.
std::array<NodeIndex, 4> checked_nodes(const VtkCellNodes& cell, std::size_t first, std::size_t count,
                                       const SourceFile& file);

}  // namespace quadline
