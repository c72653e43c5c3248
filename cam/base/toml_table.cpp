#include "toml_table.h"

#include <fmt/format.h>
#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <algorithm>

#include "fieldfab/core/error.h"

namespace fieldfab::cam {

struct TomlTable::Node {
  std::shared_ptr<const toml::table> root;  // owns the parsed file
  const toml::table* table = nullptr;
  std::string file;
};

namespace {

std::string at(const std::string& file, const toml::source_region& region) {
  return fmt::format("{}:{}", file, region.begin.line);
}

/// Rejects characters beyond ASCII outside of strings and comments, where TOML permits none: some
/// of them make toml++ 3.0 reach unreachable code (found by fuzzing).
void check_letters(std::string_view text, const std::string& file) {
  int line = 1;
  for (std::size_t i = text.starts_with("\xEF\xBB\xBF") ? 3 : 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size()) - 1;
    } else if (c == '"' || c == '\'') {
      // Up to the closing quotes: three after three opening ones, else one on the same line.
      const std::string_view three = c == '"' ? "\"\"\"" : "\'\'\'";
      const bool many = text.substr(i).starts_with(three);
      for (i += many ? 3 : 1; i < text.size() && (many || text[i] != '\n'); ++i) {
        if (text[i] == '\n') ++line;
        if (c == '"' && text[i] == '\\')
          ++i;
        else if (many ? text.substr(i).starts_with(three) : text[i] == c)
          break;
      }
      if (many)
        i += 2;
      else if (i < text.size() && text[i] == '\n')
        ++line;
    } else if (c == '\n') {
      ++line;
    } else if (static_cast<unsigned char>(c) >= 128) {
      throw Error(ErrorKind::bad_input, fmt::format("{}:{}", file, line),
                  "has a letter that only strings and comments may have");
    }
  }
}

}  // namespace

TomlTable TomlTable::parse(std::string_view text, const std::string& file) {
  check_letters(text, file);
  try {
    auto node = std::make_shared<Node>();
    node->root = std::make_shared<const toml::table>(toml::parse(text, file));
    node->table = node->root.get();
    node->file = file;
    return TomlTable(node);
  } catch (const toml::parse_error& error) {
    throw Error(ErrorKind::bad_input, at(file, error.source()), std::string(error.description()));
  }
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> names;
  for (const auto& [key, value] : *node_->table) names.emplace_back(key.str());
  return names;
}

bool TomlTable::has(const std::string& key) const { return node_->table->contains(key); }

std::string TomlTable::place(const std::string& key) const {
  const toml::node* const found = key.empty() ? nullptr : node_->table->get(key);
  const toml::source_region& region = found != nullptr ? found->source() : node_->table->source();
  return region.begin.line == 0 ? node_->file : at(node_->file, region);
}

std::optional<Value> TomlTable::value(const std::string& key) const {
  const toml::node* const node = node_->table->get(key);
  if (node == nullptr) return std::nullopt;
  if (const auto flag = node->as_boolean()) return Value(flag->get());
  if (node->is_number()) return Value(*node->value<double>());
  if (const auto text = node->as_string()) return Value(text->get());
  if (const toml::array* const array = node->as_array()) {
    std::vector<double> list;
    for (const toml::node& item : *array) {
      const auto number = item.is_number() ? item.value<double>() : std::optional<double>();
      if (!number) throw Error(ErrorKind::bad_input, place(key), fmt::format("{} must be a list of numbers", key));
      list.push_back(*number);
    }
    return Value(std::move(list));
  }
  throw Error(ErrorKind::bad_input, place(key), fmt::format("{} must be a value, not a table or a date", key));
}

template <class T>
std::optional<T> TomlTable::typed(const std::string& key, const char* what) const {
  auto found = value(key);
  if (!found) return std::nullopt;
  if (T* const value = std::get_if<T>(&*found)) return std::move(*value);
  throw Error(ErrorKind::bad_input, place(key), fmt::format("{} must be {}", key, what));
}
std::optional<double> TomlTable::number(const std::string& key) const { return typed<double>(key, "a number"); }
std::optional<std::string> TomlTable::text(const std::string& key) const { return typed<std::string>(key, "a text"); }
std::optional<bool> TomlTable::flag(const std::string& key) const { return typed<bool>(key, "true or false"); }
std::optional<std::vector<double>> TomlTable::list(const std::string& key) const {
  return typed<std::vector<double>>(key, "a list of numbers");
}

std::vector<std::string> TomlTable::texts(const std::string& key) const {
  std::vector<std::string> found;
  const toml::node* const node = node_->table->get(key);
  if (node == nullptr) return found;
  const toml::array* const array = node->as_array();
  if (array == nullptr || !std::all_of(array->begin(), array->end(), [](const toml::node& n) { return n.is_string(); }))
    throw Error(ErrorKind::bad_input, place(key), fmt::format("{} must be a list of texts", key));
  for (const toml::node& item : *array) found.push_back(item.as_string()->get());
  return found;
}

std::vector<std::vector<double>> TomlTable::rows(const std::string& key) const {
  std::vector<std::vector<double>> rows;
  const toml::node* const node = node_->table->get(key);
  if (node == nullptr) return rows;
  const auto refuse = [&] {
    throw Error(ErrorKind::bad_input, place(key), fmt::format("{} must be a list of lists of numbers", key));
  };
  const toml::array* const outer = node->as_array();
  if (outer == nullptr) refuse();
  for (const toml::node& item : *outer) {
    const toml::array* const inner = item.as_array();
    if (inner == nullptr) refuse();
    rows.emplace_back();
    for (const toml::node& number : *inner) {
      if (!number.is_number()) refuse();
      rows.back().push_back(*number.value<double>());
    }
  }
  return rows;
}

std::optional<TomlTable> TomlTable::table(const std::string& key) const {
  const toml::node* const node = node_->table->get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_table()) throw Error(ErrorKind::bad_input, place(key), fmt::format("{0} must be a table: [{0}]", key));
  auto inner = std::make_shared<Node>(*node_);
  inner->table = node->as_table();
  return TomlTable(inner);
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) const {
  std::vector<TomlTable> found;
  const toml::node* const node = node_->table->get(key);
  if (node == nullptr) return found;
  const toml::array* const array = node->as_array();
  if (array == nullptr || !std::all_of(array->begin(), array->end(), [](const toml::node& n) { return n.is_table(); }))
    throw Error(ErrorKind::bad_input, place(key), fmt::format("{0} must be a list of tables: [[{0}]]", key));
  for (const toml::node& item : *array) {
    auto inner = std::make_shared<Node>(*node_);
    inner->table = item.as_table();
    found.push_back(TomlTable(inner));
  }
  return found;
}

void TomlTable::only(const std::vector<std::string>& known) const {
  for (const std::string& key : keys())
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw Error(ErrorKind::bad_input, place(key),
                  fmt::format("there is no key '{}' here{}", key, suggestion(key, known)));
}

}  // namespace fieldfab::cam
