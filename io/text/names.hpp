#pragma once

#include <map>
#include <string>
#include <string_view>

namespace quadline {

/// The name with '_' in place of control characters and of bytes that are not UTF-8.
std::string printable(std::string_view name);

/// Makes names that Abaqus and CalculiX take: letters, digits, '_' and '-', a letter first, at most 80 characters,
/// no two alike whatever their case. Keeps the spelling as far as these rules allow.
class SetNames {
 public:
  /// A name like `wanted` that was not given out before.
  std::string make(std::string_view wanted);

 private:
  std::map<std::string, int> taken_;  ///< lower case; how often it was wanted
};

/// The name as JSON text, in quotes.
std::string json_string(std::string_view name);

}  // namespace quadline
