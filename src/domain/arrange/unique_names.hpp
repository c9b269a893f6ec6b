#pragma once

#include <map>
#include <set>
#include <string>

namespace quadline::arrangement {

/// Gives every name once: "rib", then "rib-2", "rib-3".
class UniqueNames {
 public:
  std::string take(const std::string& name) {
    if (taken_.insert(name).second) return name;
    for (int& i = next_.emplace(name, 2).first->second;; ++i)
      if (std::string other = name + "-" + std::to_string(i); taken_.insert(other).second) return other;
  }

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> next_;  // number to try, of names taken twice
};

}  // namespace quadline::arrangement
