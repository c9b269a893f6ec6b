#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "quadline/options.hpp"

namespace quadline {

struct MeshArguments {
  std::filesystem::path model;
  std::vector<std::string> outputs;  ///< as `mesh_file` takes them
  std::filesystem::path stages;      ///< folder for a snapshot after every stage; empty: none
  std::filesystem::path report;      ///< empty: none
  std::string criteria;              ///< as `read_criteria` takes them; empty: none
  Options options;
  unsigned threads = 1;
  bool json = false;  ///< the report on standard output
  bool quiet = false;
  bool keep_bad = false;  ///< write a mesh that breaks the promise too
};

struct CheckArguments {
  std::filesystem::path mesh;
  std::filesystem::path model;  ///< empty: the mesh by itself
  bool all_quad = false;        ///< triangles make it invalid
  std::string criteria;         ///< as `read_criteria` takes them; empty: none
  bool json = false;
};

struct InfoArguments {
  std::filesystem::path model;
  Options options;
  bool json = false;
};

struct DrawArguments {
  std::filesystem::path mesh;
  std::string output;  ///< as `mesh_file` takes it
};

using Arguments = std::variant<MeshArguments, CheckArguments, InfoArguments, DrawArguments>;

/// Reads the command line.
/// @return  empty where help or the version was asked for, and printed.
/// @throws InputError  the command line is wrong.
std::optional<Arguments> parse_arguments(int argc, const char* const* argv);

}  // namespace quadline
