#include "cells/cell_loop.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "quadline/generate.hpp"

namespace quadline {
namespace {

// Each job in a thread of its own.
void run_at_once(std::size_t n, const std::function<void(std::size_t)>& job) {
  std::vector<std::jthread> threads;
  for (std::size_t i = 0; i < n; ++i) threads.emplace_back([&job, i] { job(i); });
}

IdVector<CellId, double> weights(std::vector<double> values) {
  IdVector<CellId, double> of_cells;
  of_cells.raw() = std::move(values);
  return of_cells;
}

TEST(CellLoop, TakesTheLargestFirst) {
  std::vector<std::uint32_t> order;
  for_each_cell("test", weights({1, 5, 3, 5}), {}, [&](CellId c, Context&) { order.push_back(c.value); });
  EXPECT_EQ(order, (std::vector<std::uint32_t>{1, 3, 2, 0}));
}

TEST(CellLoop, RunsEveryCellOnceInThreads) {
  Context context;
  std::size_t n_jobs = 0;
  context.run_all = [&](std::size_t n, const std::function<void(std::size_t)>& job) {
    n_jobs = n;
    run_at_once(n, job);
  };
  std::vector<std::atomic<int>> calls(20);
  for_each_cell("test", weights(std::vector<double>(20, 1)), context, [&](CellId c, Context&) { ++calls[c.value]; });
  EXPECT_EQ(n_jobs, 20u);
  for (const auto& n : calls) EXPECT_EQ(n, 1);
}

TEST(CellLoop, TellsProgressAsThatOfOneStage) {
  Context context;
  std::vector<double> told;
  context.on_progress = [&](std::string_view stage, double fraction) {
    EXPECT_EQ(stage, "test");
    told.push_back(fraction);
  };
  for_each_cell("test", weights({3, 1}), context, [](CellId, Context& own) {
    own.progress("something inside", 0.5);
    own.progress("something inside", 0.2);  // does not go back
  });
  EXPECT_EQ(told, (std::vector<double>{0.375, 0.375, 0.75, 0.875, 0.875, 1}));
}

TEST(CellLoop, ThrowsTheErrorOfTheFirstCellThatFails) {
  Context context;
  for (const bool at_once : {false, true}) {
    if (at_once) context.run_all = run_at_once;
    const auto fail = [](CellId c, Context&) {
      if (c.value == 1) throw InternalError("it is broken");
    };
    try {
      for_each_cell("test", weights({1, 1, 1}), context, fail);
      FAIL() << "no error";
    } catch (const InternalError& error) {
      EXPECT_STREQ(error.what(), "it is broken");
    }
  }
}

TEST(CellLoop, LeavesOutWhatHasNotBegunWhereOneFails) {
  int n = 0;
  EXPECT_THROW(for_each_cell("test", weights({1, 1, 1}), {},
                             [&](CellId, Context&) {
                               ++n;
                               throw Cancelled();
                             }),
               Cancelled);
  EXPECT_EQ(n, 1);
}

// 3 x 3 bays, some with a hole.
Model bays() {
  Model model;
  model.size = 0.5;
  model.outer.push_back({.items = {{{0, 0}}, {{9, 0}}, {{9, 9}}, {{0, 9}}}});
  for (const double at : {3.0, 6.0}) {
    model.lines.push_back({.name = {}, .path = {.items = {{{at, 0}}, {{at + 0.4, 9}}}}});
    model.lines.push_back({.name = {}, .path = {.items = {{{0, at}}, {{9, at - 0.3}}}}});
    model.holes.push_back({.circle = Circle{{at + 1.6, 1.4}, 0.7}});
  }
  return model;
}

TEST(Threads, DoNotChangeTheMesh) {
  for (const Method method : {Method::QMorph, Method::Merge}) {
    Context alone, threads;
    threads.run_all = run_at_once;
    std::mutex mutex;
    std::string last;
    threads.on_progress = [&](std::string_view stage, double) {
      const std::lock_guard lock(mutex);
      last = stage;
    };
    const MeshResult a = generate(bays(), {.method = method}, alone), b = generate(bays(), {.method = method}, threads);
    ASSERT_FALSE(a.failure);
    EXPECT_EQ(a.report.n_cells, 9u);
    EXPECT_EQ(a.mesh.points, b.mesh.points);
    EXPECT_EQ(a.mesh.quads, b.mesh.quads);
    EXPECT_EQ(last, "measure");
  }
}

TEST(Threads, StopWhenAsked) {
  Context context;
  context.run_all = run_at_once;
  std::atomic<int> calls = 0;
  context.is_cancelled = [&] { return ++calls > 40; };
  EXPECT_THROW(generate(bays(), {}, context), Cancelled);
}

}  // namespace
}  // namespace quadline
