#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "quadline/point.hpp"

namespace quadline {

/// The place an error points at. Empty members are unknown.
struct Where {
  std::string file;
  std::string place;  ///< a JSON path such as "/lines/7/path/2", or "line 12"
  std::optional<Point> point;
};

/// Root of all errors that Quadline throws. `what()` is one line: "file: place: message at (x, y)", to nine
/// digits; `where()` holds the numbers.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message, Where where = {});
  const Where& where() const { return where_; }

 private:
  Where where_;
};

/// The input or the options are wrong: says what, where, and what to do.
class InputError : public Error {
 public:
  using Error::Error;
};

/// A file could not be written; what stood there before still stands.
class OutputError : public Error {
 public:
  using Error::Error;
};

/// The caller asked, through the Context, to stop.
class Cancelled : public Error {
 public:
  Cancelled() : Error("interrupted") {}
};

/// A defect of Quadline itself.
class InternalError : public Error {
 public:
  using Error::Error;
};

}  // namespace quadline
