// Whole files of TOML: read, with other values, and what stands in them as text.
#include "studies/io/toml_messages.h"
#include "studies/io/toml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

namespace sbeh::studies {

namespace {

constexpr std::size_t largest_file = 1 << 20;  // bytes

std::string text_of_input(const std::filesystem::path& path) {
  const std::string file = path.string();
  std::error_code unreadable;
  if (std::filesystem::is_directory(path, unreadable))
    throw InputError(fmt::format("{}: is a directory, not a file", file));
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(fmt::format("{}: cannot be read: {}", file, std::strerror(errno)));
  std::string text(largest_file + 1, '\0');
  stream.read(text.data(), std::streamsize(text.size()));
  if (stream.bad()) throw InputError(fmt::format("{}: cannot be read", file));
  text.resize(std::size_t(stream.gcount()));
  if (text.size() > largest_file)
    throw InputError(
        fmt::format("{}: is too long for an input, more than {} bytes", file, largest_file));
  return text;
}

toml::table document_of(const std::filesystem::path& path) {
  const std::string file = path.string(), text = text_of_input(path);
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: is not TOML: {}", file, error.source().begin.line,
                                 error.description()));
  }
}

TomlTable table_of(const std::filesystem::path& path, toml::table&& whole) {
  auto document = std::make_shared<const toml::table>(std::move(whole));
  TableState root{.file = path.string(), .document = document, .table = document.get()};
  return TomlTable(std::make_shared<TableState>(std::move(root)));
}

// Puts the value where its key leads to; tables on the way are made.
void put(toml::table& document, const TomlValue& value, const std::filesystem::path& path) {
  toml::table* table = &document;
  std::size_t begin = 0;
  for (std::size_t dot; (dot = value.key.find('.', begin)) != std::string::npos; begin = dot + 1) {
    const std::string name = value.key.substr(begin, dot - begin);
    toml::node& inner = table->emplace(name, toml::table{}).first->second;
    if (!inner.is_table())
      throw InputError(fmt::format("{}: {} = {}: is no table, so that there is no {} in it",
                                   path.string(), value.key.substr(0, dot), shown(inner),
                                   value.key.substr(dot + 1)));
    table = inner.as_table();
  }
  const toml::table parsed = toml::parse("value = " + value.value);
  parsed.begin()->second.visit([&](const auto& node) {  // a copy knows of no line
    table->insert_or_assign(value.key.substr(begin), node);
  });
}

}  // namespace

TomlTable TomlFile::parse(const std::filesystem::path& path) {
  return table_of(path, document_of(path));
}

TomlTable TomlFile::parse_with(const std::filesystem::path& path,
                               const std::vector<TomlValue>& values, std::string_view left_out) {
  toml::table document = document_of(path);
  document.erase(left_out);
  for (const TomlValue& value : values) put(document, value, path);
  return table_of(path, std::move(document));
}

std::vector<std::string> TomlTable::keys() const {
  if (!state_->table) return {};
  std::vector<const toml::key*> keys;  // of the table, which is in alphabetical order
  for (const auto& [key, value] : *state_->table) keys.push_back(&key);
  std::ranges::stable_sort(keys, {}, [](const toml::key* key) {
    return std::pair(key->source().begin.line, key->source().begin.column);
  });
  std::vector<std::string> names;
  for (const toml::key* key : keys) {
    const auto* inner = state_->table->get_as<toml::table>(key->str());
    if (!inner || inner->is_inline()) names.emplace_back(key->str());
    if (inner && !inner->is_inline())
      for (const std::string& name : table(key->str()).keys())
        names.push_back(fmt::format("{}.{}", key->str(), name));
  }
  return names;
}

TomlTable::Place TomlTable::place_of(const std::string& key) const {
  const std::size_t dot = key.find('.');
  if (dot == std::string::npos || (state_->table && state_->table->contains(key)))
    return {*this, key};
  return table(key.substr(0, dot)).place_of(key.substr(dot + 1));
}

std::vector<std::string> TomlTable::list(std::string_view key) const {
  const toml::node* value = has(key) ? state_->table->get(key) : nullptr;
  if (!value || !value->is_array())
    fail(key, "must be a list of values, or a range { from, to, count }");
  if (value->as_array()->empty()) fail(key, "must not be empty");
  std::vector<std::string> values;
  for (const toml::node& element : *value->as_array()) values.push_back(shown(element));
  return values;
}

std::vector<std::string> TomlTable::values(std::string_view key) const {
  std::vector<std::string> values;
  if (state_->table && state_->table->get_as<toml::table>(key)) {
    for (const double number : grid(key)) values.push_back(as_toml(number));
    return values;
  }
  values = list(key);
  for (std::size_t k = 0; k < values.size(); ++k)
    if (std::find(values.begin(), values.begin() + std::ptrdiff_t(k), values[k])
        != values.begin() + std::ptrdiff_t(k))
      fail_at(*state_, key, *state_->table->get_as<toml::array>(key)->get(k),
              "must not be there twice");
  return values;
}

}  // namespace sbeh::studies
