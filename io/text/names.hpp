#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace quadline {

/// A text as the program shows it: on one line, control characters and bytes that are not UTF-8 escaped ("\n", "\x1b").
std::string shown(std::string_view text);

/// A name as a table shows it: as `shown`, and at most 32 characters, "stiffener-of-th…-of-frame-17".
std::string shown_name(std::string_view name);

/// Columns that a shown text takes: its characters, not its bytes.
std::size_t shown_width(std::string_view text);

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
