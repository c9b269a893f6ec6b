#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quadline {

/// The known name that was probably meant: up to three letters, and half of them, to change, insert or
/// take away.
/// @return  empty where none is near.
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

}  // namespace quadline
