#pragma once

// All of the core at once. The libraries beside it have headers of their own: quadline/json.hpp and quadline/io/*.hpp.

#include "quadline/context.hpp"
#include "quadline/criteria.hpp"
#include "quadline/errors.hpp"
#include "quadline/faults.hpp"
#include "quadline/generate.hpp"
#include "quadline/inspect.hpp"
#include "quadline/mesh.hpp"
#include "quadline/model.hpp"
#include "quadline/options.hpp"
#include "quadline/point.hpp"
#include "quadline/quality.hpp"
#include "quadline/report.hpp"
#include "quadline/version.hpp"
