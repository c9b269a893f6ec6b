#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "quadline/criteria.hpp"
#include "quadline/generate.hpp"

namespace quadline {

/// A stage of a run, as it was seen from outside.
struct StageUse {
  std::string stage;
  double elapsed_s = 0;
  std::size_t peak_bytes = 0;  ///< the most memory that the program has held up to the end of the stage
};

/// A run of the mesher: what `--report` tells.
struct Run {
  std::string version;
  Model model;  ///< only its names and its size are told
  Options options;
  unsigned threads = 1;
  MeshResult result;
  std::vector<StageUse> stages;  ///< reading and writing too
  double elapsed_s = 0;
  std::vector<std::filesystem::path> files;  ///< the meshes written
  std::string criteria_name{};               ///< as asked for; empty: none
  CriteriaResult criteria{};
};

/// The report of a run as JSON text; docs/command-line.md describes it.
std::string report_json(const Run& run);

// Parts of it that other JSON output holds too.
nlohmann::ordered_json json_of(Point p);
nlohmann::ordered_json json_of(const Quality& quality);
nlohmann::ordered_json json_of(const std::vector<LineQuality>& lines);
/// The corners whose bound is below the sine of 45 degrees, and the mesh's least scaled Jacobian against all bounds.
nlohmann::ordered_json json_of(const std::vector<CellCorner>& corners, const Quality& quality);
nlohmann::ordered_json json_of(const std::vector<WorstQuad>& worst);
nlohmann::ordered_json json_of(const std::vector<Finding>& findings);
nlohmann::ordered_json json_of(const CriteriaResult& result, const std::string& name);
/// As indented text; bytes that are not UTF-8 are replaced.
std::string text_of(const nlohmann::ordered_json& json);

}  // namespace quadline
