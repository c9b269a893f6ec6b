#pragma once

#include <string>

#include "quadline/criteria.hpp"

namespace quadline {

/// The limits of a named set, or of a JSON file: an object of limits by the names of `criteria_fields`, numbers
/// in their ranges (schema/criteria.schema.json); keys that start with "x-" are passed over.
///
/// @throws InputError  neither: the name is none, or the file cannot be read or is wrong; names the file and JSON path.
Criteria read_criteria(const std::string& name_or_file);

}  // namespace quadline
