#pragma once

// Typed reading of one table of a settings file. A key is known once it has been asked for;
// finish() reports the others. What is wrong goes to the fault list and reads as absent.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "importers/value_reader.h"

namespace restframe {

class TableReader {
 public:
  TableReader(const ConfigTable& table, Reporter reporter)
      : report(std::move(reporter)), table_(table) {}

  const Reporter report;

  const ConfigValue* find(const std::string& key);
  bool has(const std::string& key) { return find(key) != nullptr; }

  std::optional<double> number(const std::string& key, const Range& range = {});
  std::optional<int> integer(const std::string& key, int low, int high);
  std::optional<std::int64_t> whole_number(const std::string& key, std::int64_t low,
                                           std::int64_t high);
  std::optional<bool> boolean(const std::string& key);
  std::optional<std::string> text(const std::string& key);
  std::optional<Vec3> vector(const std::string& key, const Range& range = {});
  const ConfigTable* table(const std::string& key);

  // The tables of [[key]].
  std::vector<const ConfigTable*> tables(const std::string& key);

  // The index in `names` of the text under `key`.
  std::optional<std::size_t> choice(const std::string& key, const std::vector<std::string>& names);

  // Of the keys that exclude each other, the first that is there; every further one is a fault.
  std::optional<std::string> one_of(const std::vector<std::string>& keys);

  // Where the key's value stands; the table's own place if the key is absent.
  TextPosition place(const std::string& key) const;
  TextPosition place() const { return table_.at; }
  TextPosition key_place(const std::string& key) const;

  // Reports every key that nobody asked for.
  void finish();

 private:
  const ConfigTable& table_;
  std::vector<std::string> known_;
};

}  // namespace restframe
