#pragma once

#include <functional>
#include <string_view>

#include "base/id.hpp"
#include "quadline/context.hpp"

namespace quadline {

/// Does the work of a stage for every cell, each by itself, the largest first; several at once where `Context::run_all`
/// can. The results must not depend on the order.
///
/// @param weights  of the cells, > 0: their parts of the stage's progress.
/// @param work     gets a cell and the context to tell its own progress, 0..1 whatever the name of the stage, and to
///                 ask whether to stop.
/// @throws what the work throws for the first cell that fails; cells that have not begun by then are left out.
void for_each_cell(std::string_view stage, const IdVector<CellId, double>& weights, const Context& context,
                   const std::function<void(CellId, Context&)>& work);

}  // namespace quadline
