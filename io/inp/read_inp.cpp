// Abaqus input as Abaqus and CalculiX take it [Abaqus, CalculiX]: nodes, plane and shell elements of first order, two-
// node lines, sets. Everything else is passed over.

#include <algorithm>
#include <map>

#include "io/inp/inp_contents.hpp"
#include "io/mesh_formats.hpp"
#include "io/text/number_text.hpp"

namespace quadline {
namespace {

// Families of element types. Behind the family stands the number of nodes (in beams a digit for the order, 1 or 3 for
// two nodes), then letters for the formulation, which does not matter here.
constexpr std::string_view kFaces[] = {"S",   "STRI", "DS",    "CPS",  "CPE",  "CPEG", "CAX",
                                       "M3D", "R3D",  "SFM3D", "DC2D", "AC2D", "DCAX"};
constexpr std::string_view kTrusses[] = {"T2D", "T3D"};
constexpr std::string_view kBeams[] = {"B2", "B3"};

/// The number between the family and the letters of the formulation; empty where the type is of no such family.
template <std::size_t N>
std::string_view digits_behind(std::string_view type, const std::string_view (&families)[N]) {
  for (const std::string_view family : families) {
    if (type.substr(0, family.size()) != family) continue;
    const std::string_view rest = type.substr(family.size());
    const std::string_view digits = rest.substr(0, rest.find_first_not_of("0123456789"));
    if (!digits.empty()) return digits;
  }
  return {};
}

/// Nodes of an element of a type in upper case: 2, 3 or 4; 0 for types that are not read.
std::size_t nodes_of(std::string_view type) {
  const std::string_view face = digits_behind(type, kFaces), beam = digits_behind(type, kBeams);
  if (face == "4") return 4;
  if (face == "3") return 3;
  return digits_behind(type, kTrusses) == "2" || beam == "1" || beam == "3" ? 2 : 0;
}

std::string_view trimmed(std::string_view text) {
  const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

/// Calls `visit` for each field between commas, trimmed; an empty last one is none.
template <class Visit>
void for_each_field(std::string_view line, Visit visit) {
  while (!line.empty()) {
    const std::size_t comma = line.find(',');
    visit(trimmed(line.substr(0, comma)));
    if (comma == line.npos) break;
    line = trimmed(line.substr(comma + 1));
  }
}

/// "*KEYWORD, NAME=VALUE, ..." with keyword and names in upper case.
struct Card {
  std::string keyword;
  std::map<std::string, std::string> parameters;

  std::string value(const char* name) const {
    const auto at = parameters.find(name);
    return at == parameters.end() ? std::string() : at->second;
  }
  bool has(const char* name) const { return parameters.count(name) > 0; }
};

class Reader {
 public:
  explicit Reader(const SourceFile& file) : file_(file) {}
  Mesh read();

 private:
  bool next_line();  ///< of those that are no comments and not blank
  [[noreturn]] void fail(const std::string& message) const { file_.fail_at_line(line_at_, message); }
  template <class Number>
  Number number(std::string_view text) const;
  void read_card();
  void start_elements();
  void data_line();
  void node_line();
  void element_line();
  void set_line(InpSets& sets, const char* kind);

  const SourceFile& file_;
  std::size_t at_ = 0, line_at_ = 0;
  std::string_view line_;
  Card card_;
  std::vector<std::int64_t> pending_;  ///< numbers of an element that goes on in the next line
  std::size_t nodes_of_type_ = 0;
  InpSets::Set* set_of_elements_ = nullptr;  ///< which the card of the elements names
  InpContents contents_;
};

bool Reader::next_line() {
  while (at_ < file_.bytes.size()) {
    const std::size_t end = std::min(file_.bytes.find('\n', at_), file_.bytes.size());
    line_at_ = at_;
    line_ = trimmed(file_.bytes.substr(at_, end - at_));
    at_ = end + 1;
    if (!line_.empty() && line_.substr(0, 2) != "**") return true;
  }
  return false;
}

template <class Number>
Number Reader::number(std::string_view text) const {
  const auto value = parse_number<Number>(text);
  if (!value) fail("a number was expected, not '" + std::string(text.substr(0, 40)) + "'");
  return *value;
}

void Reader::read_card() {
  if (!pending_.empty()) fail("the element before lacks nodes");
  card_ = {};
  bool goes_on = true;
  const auto add = [&](std::string_view field) {
    if (card_.keyword.empty()) {
      card_.keyword = upper_case(trimmed(field.substr(1)));
      if (card_.keyword.empty()) fail("a card has no keyword");
      return;
    }
    const std::size_t equals = field.find('=');
    const std::string_view value = equals == field.npos ? std::string_view() : trimmed(field.substr(equals + 1));
    card_.parameters[upper_case(trimmed(field.substr(0, equals)))] = std::string(value);
  };
  while (goes_on) {
    goes_on = line_.back() == ',';
    for_each_field(line_, add);
    if (goes_on && !next_line()) fail("the card does not end");
  }
  if (card_.keyword == "INCLUDE") fail("*INCLUDE is not followed: put the mesh into one file");
  if (card_.keyword == "ELEMENT") start_elements();
}

void Reader::start_elements() {
  const std::string type = upper_case(card_.value("TYPE"));
  nodes_of_type_ = nodes_of(type);
  if (nodes_of_type_ == 0)
    fail("elements of type '" + type + "' are not read: shells, plane elements and lines of first order are");
  set_of_elements_ = card_.has("ELSET") ? &contents_.element_sets.named(card_.value("ELSET")) : nullptr;
}

void Reader::node_line() {
  double values[3] = {0, 0, 0};
  std::size_t i = 0;
  for_each_field(line_, [&](std::string_view field) {
    if (i == 0) contents_.node_numbers.add(number<std::int64_t>(field));
    if (i >= 1 && i <= 3 && !field.empty()) values[i - 1] = number<double>(field);
    ++i;
  });
  if (i < 3) fail("a node must have a number and coordinates");
  contents_.found.mesh.points.push_back({values[0], values[1]});
  contents_.found.z.push_back(values[2]);
}

void Reader::element_line() {
  for_each_field(line_, [&](std::string_view field) { pending_.push_back(number<std::int64_t>(field)); });
  if (pending_.size() > nodes_of_type_ + 1) fail("an element has too many nodes");
  if (pending_.size() < nodes_of_type_ + 1) return;
  InpContents::Element element{nodes_of_type_, {}, line_at_};
  std::copy(pending_.begin() + 1, pending_.end(), element.nodes);
  contents_.elements.push_back(element);
  contents_.element_numbers.add(pending_[0]);
  if (set_of_elements_) {
    auto& items = set_of_elements_->items;
    if (!items.empty() && items.back().step == 1 && items.back().last < pending_[0] &&
        pending_[0] - 1 == items.back().last) {
      items.back().last = pending_[0];
    } else {
      items.push_back({pending_[0], pending_[0], 1, {}, line_at_});
    }
  }
  pending_.clear();
}

void Reader::set_line(InpSets& sets, const char* kind) {
  if (!card_.has(kind)) fail(std::string("the card lacks ") + kind + "=");
  InpSets::Set& set = sets.named(card_.value(kind));
  if (card_.has("GENERATE")) {
    std::vector<std::int64_t> range;
    for_each_field(line_, [&](std::string_view field) { range.push_back(number<std::int64_t>(field)); });
    if (range.size() == 2) range.push_back(1);
    if (range.size() != 3 || range[2] < 1) fail("GENERATE takes first, last, step");
    set.items.push_back({range[0], range[1], range[2], {}, line_at_});
    return;
  }
  for_each_field(line_, [&](std::string_view field) {
    const auto value = parse_number<std::int64_t>(field);
    set.items.push_back(
        {value.value_or(0), value.value_or(0), 1, value ? std::string() : std::string(field), line_at_});
  });
}

void Reader::data_line() {
  if (card_.keyword == "NODE") node_line();
  if (card_.keyword == "ELEMENT") element_line();
  if (card_.keyword == "NSET") set_line(contents_.node_sets, "NSET");
  if (card_.keyword == "ELSET") set_line(contents_.element_sets, "ELSET");
}

Mesh Reader::read() {
  while (next_line()) {
    if (line_[0] == '*') {
      read_card();
    } else {
      data_line();
    }
  }
  if (!pending_.empty()) fail("the last element lacks nodes");
  return plane_mesh(found_mesh(std::move(contents_), file_), file_);
}

}  // namespace

Mesh parse_inp(std::string_view bytes, const std::string& file) {
  const SourceFile source{bytes, file};
  return Reader(source).read();
}

}  // namespace quadline
