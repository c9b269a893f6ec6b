#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/criteria_table.hpp"
#include "cli/files.hpp"
#include "cli/interrupt.hpp"
#include "cli/model_size.hpp"
#include "cli/progress_bar.hpp"
#include "cli/quality_table.hpp"
#include "cli/threads.hpp"
#include "io/json/report_json.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/names.hpp"
#include "quadline/io/mesh_io.hpp"
#include "quadline/io/read_criteria.hpp"
#include "quadline/io/read_model.hpp"
#include "quadline/version.hpp"

namespace quadline {

namespace {

namespace fs = std::filesystem;

std::size_t peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

/// Seconds and memory of what a run does, from the first word that each stage sends.
class StageWatch {
 public:
  void enter(std::string_view stage) {
    if (!seen_.empty() && seen_.back().stage == stage) return;
    leave();
    seen_.push_back({std::string(stage), 0, 0});
    start_ = Clock::now();
    is_open_ = true;
  }

  void leave() {
    if (!is_open_) return;
    seen_.back().elapsed_s = std::chrono::duration<double>(Clock::now() - start_).count();
    seen_.back().peak_bytes = peak_bytes();
    is_open_ = false;
  }

  /// What was seen, with the mesher's own times, which leave out what the snapshots take. The stages inside the cells,
  /// which run at the same time, share the memory that all cells had.
  std::vector<StageUse> stages(const std::vector<StageTime>& times) const {
    std::vector<StageUse> all{seen_.front()};
    std::size_t at = 0;
    for (const StageTime& time : times) {
      if (at + 1 < seen_.size() && (seen_[at + 1].stage == time.stage || seen_[at + 1].stage == "cells")) ++at;
      all.push_back({time.stage, time.elapsed_s, seen_[at].peak_bytes});
    }
    all.insert(all.end(), seen_.begin() + static_cast<std::ptrdiff_t>(at) + 1, seen_.end());
    return all;
  }

  double elapsed_s() const { return std::chrono::duration<double>(Clock::now() - born_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  std::vector<StageUse> seen_;  ///< the first is no stage of the mesher
  Clock::time_point born_ = Clock::now(), start_ = born_;
  bool is_open_ = false;
};

/// Writes what `--stages` asks for: 01-triangulation.svg, 01-triangulation.vtu, ...
class Snapshots {
 public:
  explicit Snapshots(const fs::path& folder) : folder_(folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw OutputError("cannot be made: " + error.message(), Where{folder.string(), {}, {}});
  }

  void write(std::string_view name, const Mesh& mesh) {
    const std::string number = std::to_string(++n_);
    const fs::path stem = folder_ / (std::string(number.size() < 2 ? "0" : "") + number + "-" + std::string(name));
    for (const char* format : {"svg", "vtu"}) write_mesh(mesh, {stem.string() + '.' + format, format});
  }

 private:
  fs::path folder_;
  int n_ = 0;
};

/// A mesh or report on standard output leaves no place for words.
bool takes_standard_output(const MeshArguments& arguments) {
  for (const std::string& output : arguments.outputs)
    if (is_standard_output(mesh_file(output).path)) return true;
  return !arguments.report.empty() && is_standard_output(arguments.report);
}

/// Errors that would come after the work are found before it.
void check_outputs(const MeshArguments& arguments) {
  std::vector<fs::path> files;
  for (const std::string& output : arguments.outputs) files.push_back(mesh_file(output).path);
  if (files.empty() && arguments.report.empty() && arguments.stages.empty() && !arguments.json)
    throw InputError(ErrorCode::InvalidOption, "expected a file to write: give -o FILE");
  if (!arguments.report.empty()) files.push_back(arguments.report);
  std::vector<fs::path> inputs = files_of_model(arguments.model);
  if (!arguments.criteria.empty()) inputs.push_back(arguments.criteria);
  for (std::size_t i = 0; i < files.size(); ++i) {
    refuse_overwriting(files[i], inputs);
    for (std::size_t j = 0; j < i; ++j)
      if (is_same_file(files[i], files[j]))
        throw InputError(ErrorCode::InvalidOption, "is given twice", Where{files[i].string(), {}, {}});
    check_can_write(files[i]);
  }
  if (arguments.json && takes_standard_output(arguments))
    throw InputError(ErrorCode::InvalidOption,
                     "standard output takes a file already: give --report FILE instead of --json");
}

void write_files(const MeshArguments& arguments, Run& run, StageWatch& watch) {
  watch.enter("write");
  for (const std::string& output : arguments.outputs) {
    if (is_interrupted()) throw Cancelled();
    const MeshFile file = mesh_file(output);
    write_mesh(run.result.mesh, file);
    run.files.push_back(file.path);
  }
  watch.leave();
}

/// "on 3 lines: 57 edges, 60 nodes"; empty without lines.
std::string on_lines(const Mesh& mesh) {
  std::size_t n_lines = 0, n_edges = 0;
  std::vector<NodeIndex> nodes;
  for (const EdgeSet& curve : mesh.curves) {
    if (curve.kind != CurveKind::Line) continue;
    ++n_lines;
    n_edges += curve.edges.size();
    for (const auto& edge : curve.edges) nodes.insert(nodes.end(), edge.begin(), edge.end());
  }
  if (n_lines == 0) return "";
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return "on " + counted(n_lines, "line", "lines") + ": " + counted(n_edges, "edge", "edges") + ", " +
         counted(nodes.size(), "node", "nodes") + '\n';
}

/// "cells: 1 grid (120 quads), 2 by Q-Morph (300 quads)": what there is.
std::string by_origin(const CellOrigins& cells) {
  std::string out;
  const auto tell = [&](const std::string& what, const CellOrigins::Share& share) {
    if (share.n_cells == 0) return;
    out += (out.empty() ? "cells: " : ", ") + what + " (" + counted(share.n_quads, "quad", "quads") + ')';
  };
  tell(counted(cells.grids.n_cells, "grid", "grids"), cells.grids);
  tell(std::to_string(cells.fronts.n_cells) + " by Q-Morph", cells.fronts);
  tell(std::to_string(cells.halved.n_cells) + " halved", cells.halved);
  tell(counted(cells.copies.n_cells, "copy", "copies"), cells.copies);
  return out + '\n';
}

std::string summary(const Run& run) {
  const Report& report = run.result.report;
  std::string out = run.model.name.empty() ? shown(run.model.file) : shown_name(run.model.name);
  out += ": " + counted(report.quality.n_quads, "quad", "quads") + ", " +
         counted(report.quality.n_nodes, "node", "nodes") + ", " + fixed(run.elapsed_s, 2) + " s\n";
  out += on_lines(run.result.mesh) + by_origin(report.cells);
  out += before_and_after(report.before_smoothing, report.quality);
  out += corner_line(report.corners, report.quality) + worst_table(report.worst) + line_table(report.lines);
  if (!run.criteria_name.empty()) out += criteria_table(run.criteria_name, run.criteria);
  for (const fs::path& file : run.files) out += "written: " + shown(file.string()) + '\n';
  return out;
}

}  // namespace

int run(const MeshArguments& arguments) {
  check_outputs(arguments);
  StageWatch watch;
  watch.enter("read");
  Run run;
  run.version = kVersion;
  run.model = read_model(arguments.model, arguments.options.size);
  run.options = arguments.options;
  run.threads = arguments.threads;
  check_size_given(run.model, run.options);
  if (!arguments.criteria.empty()) run.options.criteria = read_criteria(arguments.criteria);
  run.criteria_name = arguments.criteria;
  std::optional<Snapshots> snapshots;
  if (!arguments.stages.empty()) snapshots.emplace(arguments.stages);
  ProgressBar bar(!arguments.quiet);
  Context context;
  context.run_all = run_on_threads(arguments.threads);
  context.is_cancelled = is_interrupted;
  std::mutex progress;
  context.on_progress = [&](std::string_view stage, double fraction) {
    const std::lock_guard lock(progress);
    watch.enter(stage);
    bar.show(stage, fraction);
  };
  if (snapshots) context.on_snapshot = [&](std::string_view name, const Mesh& mesh) { snapshots->write(name, mesh); };
  run.result = generate(run.model, run.options, context);
  watch.leave();

  if (run.options.criteria) run.criteria = evaluate(run.result.mesh, *run.options.criteria, run.result.edge_sizes);

  const auto& failure = run.result.failure;
  const bool writes = !failure || arguments.keep_bad;
  bar.show("write", 0);
  if (writes) write_files(arguments, run, watch);
  bar.clear();
  run.stages = watch.stages(run.result.report.stages);
  run.elapsed_s = watch.elapsed_s();
  if (writes && !arguments.report.empty()) write_atomically(arguments.report, report_json(run));
  print_findings(run.result.report.findings, run.model.file, arguments.quiet);
  if (arguments.json) {
    print(report_json(run));
  } else if (!arguments.quiet && writes && !takes_standard_output(arguments)) {
    print(summary(run));
  }
  if (!failure) return kDone;
  const InputError error("no valid mesh: " + failure->stage + ": " + failure->reason,
                         Where{run.model.file, {}, failure->at});
  complain(error.what());
  return kBrokenPromise;
}

}  // namespace quadline
