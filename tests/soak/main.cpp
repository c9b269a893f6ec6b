// The soak: seeded random models through the mesher, without end if wanted. See docs/robustness.md.
#include <poll.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "minimise.hpp"
#include "model_json.hpp"
#include "trial.hpp"
#include "wild_models.hpp"

namespace {

using namespace quadline;

struct Arguments {
  int number = 1000, first = 1, processes = 2, minimise_runs = 300;
  std::string family;
  double seconds = 1e9, model_seconds = 30, coarsest = 1;
  bool keep_going = false;
  std::string folder = "out/soak";
  std::string models;  ///< folder; not empty: the models are written there, and none is meshed
};

struct Tally {
  int runs = 0, valid = 0, input_errors = 0, retried = 0;
  std::map<std::string, int> failures;
  double longest_s = 0;
  int longest_seed = 0;
};

// Sizes from those of the family to `coarsest` times as large: elements that are larger than the details, and fewer.
void coarsen(Model& model, Dice& dice, double coarsest) {
  const double factor = std::pow(coarsest, dice.number(0, 1));
  const auto scale = [factor](std::optional<double>& size) {
    if (size) *size *= factor;
  };
  model.size *= factor;
  for (Line& line : model.lines) scale(line.size);
  for (NamedPoint& point : model.points) scale(point.size);
  for (Region& region : model.regions) scale(region.size);
}

Model model_of(const Family& family, int seed, double coarsest) {
  Dice dice(static_cast<std::uint64_t>(seed));
  Model model = family.make(dice);
  model.name = family.name + "-" + std::to_string(seed);
  if (coarsest > 1) coarsen(model, dice, coarsest);
  return model;
}

void write(const Model& model, const std::string& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/" + model.name + ".json") << to_model_json(model);
}

class Soak {
 public:
  explicit Soak(const Arguments& arguments) : arguments_(arguments) {}

  /// Returns the number of failures.
  int run() {
    for (int i = 0; i < arguments_.number && !is_over(); ++i)
      for (const Family& family : wild_families())
        if (arguments_.family.empty() || arguments_.family == family.name) start(family, arguments_.first + i);
    while (!running_.empty()) finish_one();
    print();
    limit_refusals();
    return n_failures_;
  }

 private:
  struct Running {
    const Family* family;
    int seed;
    Trial trial;
  };

  bool is_over() const {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    return elapsed.count() > arguments_.seconds || (n_failures_ > 0 && !arguments_.keep_going);
  }

  void start(const Family& family, int seed) {
    if (is_over()) return;
    if (!arguments_.models.empty()) return write(model_of(family, seed, arguments_.coarsest), arguments_.models);
    if (running_.size() == static_cast<std::size_t>(arguments_.processes)) finish_one();
    running_.push_back({&family, seed, Trial(model_of(family, seed, arguments_.coarsest), arguments_.model_seconds)});
  }

  void finish_one() {
    std::vector<pollfd> waits;
    double left_s = arguments_.model_seconds;
    for (const Running& r : running_) {
      waits.push_back({r.trial.fd(), POLLIN, 0});
      left_s = std::min(left_s, r.trial.left_s());
    }
    poll(waits.data(), waits.size(), static_cast<int>(1000 * left_s));
    std::size_t which = 0;  // the first to end, or the oldest, whose time is up
    while (which + 1 < waits.size() && waits[which].revents == 0) ++which;
    if (waits[which].revents == 0) which = 0;
    Running ended = running_[which];
    running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(which));
    note(*ended.family, ended.seed, ended.trial.finish());
  }

  void note(const Family& family, int seed, const Outcome& outcome) {
    Tally& tally = tallies_[family.name];
    ++tally.runs;
    tally.valid += outcome.kind.empty();
    tally.input_errors += outcome.is_input_error();
    tally.retried += outcome.kind.empty() && outcome.attempts > 1;
    if (outcome.elapsed_s > tally.longest_s) tally.longest_s = outcome.elapsed_s, tally.longest_seed = seed;
    if (!outcome.is_failure()) return;
    ++n_failures_;
    std::printf("%s, seed %d: %s\n", family.name.c_str(), seed, outcome.kind.c_str());
    if (tally.failures[outcome.kind]++ == 0) keep_smallest(family, seed, outcome.kind);
    std::fflush(stdout);
  }

  void keep_smallest(const Family& family, int seed, const std::string& kind) {
    const auto fails = [&](const Model& m) { return Trial(m, arguments_.model_seconds).finish().kind == kind; };
    Model smallest = minimise(model_of(family, seed, arguments_.coarsest), fails, arguments_.minimise_runs);
    smallest.about = kind;
    write(smallest, arguments_.folder);
    std::printf("  smallest model: %s/%s.json\n", arguments_.folder.c_str(), smallest.name.c_str());
  }

  void print() const {
    std::printf("\n%-20s %7s %7s %7s %7s %7s  %s\n", "family", "runs", "valid", "input", "failed", "retried",
                "longest");
    for (const auto& [name, t] : tallies_) {
      std::printf("%-20s %7d %7d %7d %7d %7d  %.2f s (seed %d)\n", name.c_str(), t.runs, t.valid, t.input_errors,
                  t.runs - t.valid - t.input_errors, t.retried, t.longest_s, t.longest_seed);
      for (const auto& [kind, n] : t.failures) std::printf("    %d x %s\n", n, kind.c_str());
    }
  }

  // A model that is refused as input costs no mesh and breaks no promise: so that refusing everything is no way to
  // pass, each one beyond what its family may have is a failure.
  void limit_refusals() {
    for (const Family& family : wild_families()) {
      const Tally& tally = tallies_[family.name];
      const int most = static_cast<int>(std::ceil(family.most_refused * tally.runs));
      if (tally.input_errors <= most) continue;
      n_failures_ += tally.input_errors - most;
      std::printf("%s: %d of %d models refused as input, %d may be\n", family.name.c_str(), tally.input_errors,
                  tally.runs, most);
    }
  }

  const Arguments& arguments_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::vector<Running> running_;
  std::map<std::string, Tally> tallies_;
  int n_failures_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Meshes seeded random models; exit code 1 where one failed");
  app.add_option("--number", arguments.number, "models of each family");
  app.add_option("--first", arguments.first, "first seed");
  app.add_option("--family", arguments.family, "only this family");
  app.add_option("--seconds", arguments.seconds, "start no model after so many seconds");
  app.add_option("--model-seconds", arguments.model_seconds, "a model that takes longer hangs");
  app.add_option("--coarsest", arguments.coarsest, "sizes up to so many times as large, >= 1");
  app.add_option("--processes", arguments.processes, "models at a time")->check(CLI::PositiveNumber);
  app.add_option("--minimise-runs", arguments.minimise_runs, "runs to make a failing model smaller");
  app.add_option("--out", arguments.folder, "folder of the failing models");
  app.add_option("--models", arguments.models, "write the models into this folder, and mesh none");
  app.add_flag("--keep-going", arguments.keep_going, "do not stop at the first failure");
  CLI11_PARSE(app, argc, argv);
  return Soak(arguments).run() == 0 ? 0 : 1;
}
