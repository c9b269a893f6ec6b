#pragma once

#include <string>

#include "quadline/model.hpp"

namespace quadline {

/// The model as "model v1", with all digits.
std::string to_model_json(const Model& model);

}  // namespace quadline
