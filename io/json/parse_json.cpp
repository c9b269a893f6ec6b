// The parser is nlohmann's; its events build the document here, so that the limits hold while it is read, not after.
#include "io/json/parse_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "quadline/errors.hpp"

namespace quadline {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kDeepest = 64;  // nested lists and objects; the deepest format of ours needs six

/// The parser's own words, as far as they help: without its prefix, and without the text that it stumbled on.
std::string reason_of(const std::string& what) {
  const std::size_t start = what.find(" - ");
  const std::size_t end = what.find("; last read");
  if (start == what.npos) return "syntax error";
  std::string reason = what.substr(start + 3, end == what.npos ? end : end - start - 3);
  const std::size_t expected = what.find("; expected ");
  if (expected != what.npos && reason.find("; expected ") == reason.npos) reason += what.substr(expected);
  return reason;
}

class Builder : public nlohmann::json_sax<Json> {
 public:
  Builder(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  Json take() { return std::move(root_); }

  bool null() override { return put(nullptr); }
  bool boolean(bool value) override { return put(value); }
  bool number_integer(number_integer_t value) override { return put(value); }
  bool number_unsigned(number_unsigned_t value) override { return put(value); }
  bool number_float(number_float_t value, const string_t&) override { return put(value); }
  bool string(string_t& value) override { return put(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // not in text

  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    keys_.back() = name;
    if (open_.back()->contains(name))
      throw InputError(ErrorCode::FileSyntax, "the key '" + name + "' stands twice in this object: take one out",
                       where(path_of_next()));
    return true;
  }

  bool parse_error(std::size_t byte, const std::string& last, const nlohmann::detail::exception& error) override {
    constexpr int kOutOfRange = 406;
    if (error.id == kOutOfRange)
      throw InputError(ErrorCode::FileSyntax, "the number " + last.substr(0, 40) + " is too large",
                       where(path_of_next()));
    throw InputError(ErrorCode::FileSyntax, "no valid JSON: " + reason_of(error.what()), where(line_and_column(byte)));
  }

 private:
  Where where(const std::string& place) const { return {file_, place, {}}; }

  Json* put(Json value) {
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    Json& parent = *open_.back();
    if (parent.is_array()) {
      parent.push_back(std::move(value));
      return &parent.back();
    }
    Json& slot = parent[keys_.back()];
    slot = std::move(value);
    return &slot;
  }

  bool open(Json value) {
    if (open_.size() == kDeepest)
      throw InputError(ErrorCode::FileSyntax, "lists or objects nested more than " + std::to_string(kDeepest) + " deep",
                       where(path_of_next()));
    open_.push_back(put(std::move(value)));
    keys_.emplace_back();
    return true;
  }

  bool close() {
    open_.pop_back();
    keys_.pop_back();
    return true;
  }

  /// Of the value that is being read.
  std::string path_of_next() const {
    Json::json_pointer pointer;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      if (!open_[i]->is_array()) {
        pointer /= keys_[i];
      } else {
        pointer /= open_[i]->size() - (i + 1 < open_.size() ? 1 : 0);  // what is open has its place already
      }
    }
    return pointer.to_string();
  }

  /// `byte` counts from one.
  std::string line_and_column(std::size_t byte) const {
    const std::string_view before = bytes_.substr(0, std::min(std::max<std::size_t>(byte, 1) - 1, bytes_.size()));
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t start = before.rfind('\n') + 1;  // 0 where there is none
    return "line " + std::to_string(line) + ", column " + std::to_string(before.size() - start + 1);
  }

  std::string_view bytes_;
  const std::string& file_;
  Json root_;
  std::vector<Json*> open_;        ///< lists and objects that have not ended yet, from the outside in
  std::vector<std::string> keys_;  ///< for each of them, the last key
};

}  // namespace

nlohmann::json parse_json(std::string_view bytes, const std::string& file) {
  const Where where{file, {}, {}};
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
    throw InputError(ErrorCode::FileSyntax, "is UTF-16: save it as UTF-8", where);
  if (bytes.find_first_not_of(" \t\r\n") == bytes.npos)
    throw InputError(ErrorCode::FileSyntax, "the file is empty", where);
  Builder builder(bytes, file);
  Json::sax_parse(bytes, &builder);
  return builder.take();
}

}  // namespace quadline
