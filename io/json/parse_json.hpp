#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace quadline {

/// Parses JSON text (UTF-8, with or without a byte order mark), and refuses what a general parser lets pass: a key that
/// stands twice in an object, nesting deeper than 64, numbers beyond the range of a double.
///
/// @throws InputError  with `file`, and the line and column, or the JSON path.
nlohmann::json parse_json(std::string_view bytes, const std::string& file);

}  // namespace quadline
