// The words with which a table of a TOML file is refused.
#pragma once

#include "studies/io/scales.h"
#include "studies/io/toml_reader.h"

#include <toml++/toml.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

/// What the copies of one TomlTable share.
struct TableState {
  std::string file;
  std::shared_ptr<const toml::table> document;        ///< keeps `table` alive
  const toml::table* table = nullptr;                 ///< null: absent, no keys
  std::string section = {};                           ///< "scan" of [scan]; empty at the top
  std::string prefix = {};                            ///< "L." in the inline table L = { … }
  int line = 0;                                       ///< 0: absent
  std::vector<std::string> asked = {};                ///< in the order of asking
  std::shared_ptr<const TableState> file_table = {};  ///< of the whole file; null: this one
  std::optional<Scales> scales = {};                  ///< of values with a unit
};

/// The line at which a value stands, and "file:line" of it; the file alone for line 0.
int line_of(const toml::node& node);
std::string place(const TableState& table, int line);

/// A value as it would be written in the file, on one line.
std::string shown(const toml::node& node);

/// "key" as TOML wants it, "[section] key", and "outer.key" of the table [outer.key].
std::string shown_key(std::string_view key);
std::string full_name(const TableState& table, std::string_view key);
std::string section_name(const TableState& table, std::string_view key);

/// Whether somebody has asked for the key.
bool asked_for(const TableState& table, std::string_view key);

/// "file:line: key: unknown key" (or table) with what was probably meant.
std::string unknown(const TableState& table, const toml::key& key,
                    const std::optional<std::string>& meant);

/// The table of this kind of input, asked for already, in which the key has its place; empty where that is none, or
/// the one in which it stands.
std::optional<std::string> place_of_key(const TableState& table, std::string_view key);

/// Throws InputError at a value, or at an element of a list that is the value.
[[noreturn]] void fail_at(const TableState& table, std::string_view key, const toml::node& value,
                          std::string_view what);

/// Throws InputError where a key that nobody asked for has nearly the letters of one of these.
void refuse_misspelt(const TableState& table, const std::vector<std::string>& keys);

/// Throws InputError: a required key of this kind is not there. A present key of nearly the same
/// letters is taken for a misprint.
[[noreturn]] void fail_missing(const TableState& table, std::string_view key,
                               std::string_view kind);

}  // namespace sbeh::studies
