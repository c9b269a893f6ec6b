#include "quadline/io/read_criteria.hpp"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "io/json/parse_json.hpp"
#include "io/text/nearest_name.hpp"
#include "io/text/number_text.hpp"
#include "io/text/read_bytes.hpp"
#include "quadline/errors.hpp"

namespace quadline {

namespace {

const CriteriaField* field_called(const std::string& name) {
  for (const CriteriaField& field : criteria_fields())
    if (field.name == name) return &field;
  return nullptr;
}

[[noreturn]] void refuse_name(const std::string& name, const Where& where) {
  std::vector<std::string> known;
  for (const CriteriaField& field : criteria_fields()) known.emplace_back(field.name);
  const std::string nearest = nearest_name(name, known);
  throw InputError(ErrorCode::FileSyntax,
                   "unknown limit '" + name +
                       "': " + (nearest.empty() ? "docs/measures.md lists them" : "did you mean '" + nearest + "'?"),
                   where);
}

void refuse_out_of_range(double value, const CriteriaField& field, const Where& where) {
  if (value >= field.low && value <= field.high) return;
  std::string low, high;
  append_number(low, field.low);
  append_number(high, field.high);
  throw InputError(ErrorCode::FileSyntax,
                   std::isinf(field.high) ? "expected a number of " + low + " or more"
                                          : "expected a number from " + low + " to " + high,
                   where);
}

/// "min_aspect" beside "max_aspect": a pair of limits that no value can keep.
void refuse_crossed(const Criteria& criteria, const std::string& file) {
  for (const CriteriaField& field : criteria_fields()) {
    if (!field.is_least) continue;
    const CriteriaField* most = field_called("max" + std::string(field.name.substr(3)));
    if (most && criteria.*field.limit && criteria.*most->limit && *(criteria.*field.limit) > *(criteria.*most->limit))
      throw InputError(ErrorCode::FileSyntax, "is above '" + std::string(most->name) + "': nothing can keep both",
                       Where{file, "/" + std::string(field.name), {}});
  }
}

}  // namespace

Criteria read_criteria(const std::string& name_or_file) {
  if (const auto named = named_criteria(name_or_file)) return *named;
  if (std::filesystem::path(name_or_file).extension() != ".json")
    throw InputError(ErrorCode::InvalidOption, "no criteria are called '" + name_or_file +
                                                   "': use csr-fine, hypermesh-10mm, growth or a .json file");
  const nlohmann::json limits = parse_json(read_bytes(name_or_file), name_or_file);
  if (!limits.is_object())
    throw InputError(ErrorCode::FileSyntax, "expected an object of limits", Where{name_or_file, {}, {}});
  Criteria criteria;
  for (const auto& [name, value] : limits.items()) {
    if (name.starts_with("x-") || name == "$schema") continue;
    const Where where{name_or_file, "/" + name, {}};
    const CriteriaField* field = field_called(name);
    if (!field) refuse_name(name, where);
    if (!value.is_number()) throw InputError(ErrorCode::FileSyntax, "expected a number", where);
    refuse_out_of_range(value.get<double>(), *field, where);
    criteria.*field->limit = value.get<double>();
  }
  refuse_crossed(criteria, name_or_file);
  return criteria;
}

}  // namespace quadline
