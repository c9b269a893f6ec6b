#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "quadline/point.hpp"

namespace quadline {

/// What kind of error it is: for programs, which should not read the texts. Codes may be added, none changes its
/// meaning.
enum class ErrorCode {
  InvalidOption,   ///< an option or an argument has a value that it may not have
  InvalidModel,    ///< the model makes no domain: a loop without area, a size that is not positive, and the like
  InvalidMesh,     ///< a mesh holds no plane mesh: no elements, not in a plane, arrays that do not fit each other
  FileUnreadable,  ///< a file is missing, or the system does not let it be read
  FileSyntax,      ///< a file is not what its format says
  UnknownFormat,   ///< no format has that name or extension
  TooManyQuads,    ///< the mesh would need more than Options::max_quads
  CannotWrite,     ///< OutputError
  Cancelled,       ///< Cancelled
  Internal,        ///< InternalError
};

/// The name of a code as it stands above, "InvalidOption".
const char* name_of(ErrorCode code);

/// The place an error points at. Empty members are unknown.
struct Where {
  std::string file;
  std::string place;  ///< a JSON path such as "/lines/7/path/2", or "line 12"
  std::optional<Point> point;
};

/// Root of all errors that Quadline throws. `what()` is one line: "file: place: message at (x, y)", to nine
/// digits; `where()` holds the numbers, `code()` tells the kind.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& message, Where where = {});
  ErrorCode code() const { return code_; }
  const Where& where() const { return where_; }

 private:
  ErrorCode code_;
  Where where_;
};

/// The input or the options are wrong: says what, where, and what to do.
class InputError : public Error {
 public:
  using Error::Error;
  /// Of a model: most are.
  explicit InputError(const std::string& message, Where where = {})
      : Error(ErrorCode::InvalidModel, message, std::move(where)) {}
};

/// A file could not be written; what stood there before still stands.
class OutputError : public Error {
 public:
  explicit OutputError(const std::string& message, Where where = {})
      : Error(ErrorCode::CannotWrite, message, std::move(where)) {}
};

/// The caller asked, through the Context, to stop.
class Cancelled : public Error {
 public:
  Cancelled() : Error(ErrorCode::Cancelled, "interrupted") {}
};

/// A defect of Quadline itself.
class InternalError : public Error {
 public:
  explicit InternalError(const std::string& message, Where where = {})
      : Error(ErrorCode::Internal, message, std::move(where)) {}
};

}  // namespace quadline
