#include "quadline/errors.hpp"

#include <charconv>

#include "base/utf8.hpp"

namespace quadline {

namespace {

/// Nine digits: a place for people to look at, not the number itself.
std::string text_of(double x) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::general, 9).ptr;
  return {buffer, end};
}

std::string one_line(const std::string& message, const Where& where) {
  std::string text;
  if (!where.file.empty()) text += where.file + ": ";
  if (!where.place.empty()) text += where.place + ": ";
  text += message;
  if (where.point) text += " at (" + text_of(where.point->x) + ", " + text_of(where.point->y) + ")";
  // Names come from files: one line, no codes for the terminal, and UTF-8 whatever the file holds.
  return escaped(text);
}

}  // namespace

const char* name_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::InvalidOption:
      return "InvalidOption";
    case ErrorCode::InvalidModel:
      return "InvalidModel";
    case ErrorCode::InvalidMesh:
      return "InvalidMesh";
    case ErrorCode::FileUnreadable:
      return "FileUnreadable";
    case ErrorCode::FileSyntax:
      return "FileSyntax";
    case ErrorCode::UnknownFormat:
      return "UnknownFormat";
    case ErrorCode::TooManyQuads:
      return "TooManyQuads";
    case ErrorCode::CannotWrite:
      return "CannotWrite";
    case ErrorCode::Cancelled:
      return "Cancelled";
    case ErrorCode::Internal:
      break;
  }
  return "Internal";
}

Error::Error(ErrorCode code, const std::string& message, Where where)
    : std::runtime_error(one_line(message, where)), code_(code), where_(std::move(where)) {}

}  // namespace quadline
