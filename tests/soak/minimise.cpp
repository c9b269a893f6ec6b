#include "minimise.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace quadline {

namespace {

class Minimiser {
 public:
  Minimiser(Model model, const std::function<bool(const Model&)>& fails, int max_runs)
      : best_(std::move(model)), fails_(fails), left_(max_runs) {}

  Model run() {
    do {
      changed_ = false;
      drop(&Model::lines);
      drop(&Model::holes);
      drop(&Model::points);
      drop(&Model::regions);
      drop_sizes();
      for_paths([this](auto path) { drop_corners(path); });
    } while (changed_ && left_ > 0);
    for (const double unit : {1.0, 0.1, 0.01, 0.001}) for_paths([this, unit](auto path) { round(path, unit); });
    return std::move(best_);
  }

 private:
  template <class Change>
  bool try_to(Change change) {
    if (left_ <= 0) return false;
    Model smaller = best_;
    change(smaller);
    --left_;
    if (!fails_(smaller)) return false;
    best_ = std::move(smaller);
    return changed_ = true;
  }

  /// Halves first, then quarters, down to single ones.
  template <class T>
  void drop(std::vector<T> Model::* list) {
    for (std::size_t step = ((best_.*list).size() + 1) / 2; step > 0; step /= 2) {
      for (std::size_t i = 0; i < (best_.*list).size();) {
        const bool dropped = try_to([&](Model& m) {
          auto& items = m.*list;
          const std::size_t end = std::min(i + step, items.size());
          items.erase(items.begin() + static_cast<std::ptrdiff_t>(i), items.begin() + static_cast<std::ptrdiff_t>(end));
        });
        if (!dropped) i += step;
      }
    }
  }

  void drop_sizes() {
    const auto drop_of = [this](auto list) {
      for (std::size_t i = 0; i < (best_.*list).size(); ++i)
        if ((best_.*list)[i].size) try_to([&](Model& m) { (m.*list)[i].size.reset(); });
    };
    drop_of(&Model::lines);
    drop_of(&Model::points);
    drop_of(&Model::regions);
  }

  /// Calls visit(path_of) for every path, where path_of(model) is that path of any copy of the model.
  template <class Visit>
  void for_paths(Visit visit) {
    for (std::size_t i = 0; i < best_.outer.size(); ++i) visit([i](Model& m) -> Path& { return m.outer[i]; });
    for (std::size_t i = 0; i < best_.holes.size(); ++i) visit([i](Model& m) -> Path& { return m.holes[i]; });
    for (std::size_t i = 0; i < best_.lines.size(); ++i) visit([i](Model& m) -> Path& { return m.lines[i].path; });
  }

  template <class PathOf>
  void drop_corners(PathOf path) {
    for (std::size_t i = 0; path(best_).items.size() > 2 && i < path(best_).items.size();) {
      const bool dropped = try_to([&](Model& m) {
        auto& items = path(m).items;
        items.erase(items.begin() + static_cast<std::ptrdiff_t>(i));
        items.front().via.reset();
      });
      if (!dropped) ++i;
    }
  }

  template <class PathOf>
  void round(PathOf path, double unit) {
    const auto rounded = [unit](double x) { return std::round(x / unit) * unit; };
    for (std::size_t i = 0; i < path(best_).items.size(); ++i)
      for (double Point::* axis : {&Point::x, &Point::y}) {
        const double from = path(best_).items[i].to.*axis, to = rounded(from);
        if (to != from && !is_short(from, unit)) try_to([&](Model& m) { path(m).items[i].to.*axis = to; });
      }
  }
  /// Was it rounded to a larger unit before?
  static bool is_short(double x, double unit) {
    for (double u = 10 * unit; u <= 1; u *= 10)
      if (std::round(x / u) * u == x) return true;
    return false;
  }

  Model best_;
  const std::function<bool(const Model&)>& fails_;
  int left_;
  bool changed_ = false;
};

}  // namespace

Model minimise(Model model, const std::function<bool(const Model&)>& fails, int max_runs) {
  return Minimiser(std::move(model), fails, max_runs).run();
}

}  // namespace quadline
