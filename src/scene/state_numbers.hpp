#pragma once
#include "step/observation.hpp"

#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace breccia {

/// What modules archive, in memory.
class StateNumbers {
 public:
  enum class Kind : std::int64_t { same, sum, list, rows };
  struct Entry {
    Kind kind = Kind::same;
    bool whole_numbers = false;
    std::vector<double> reals;
    std::vector<std::int64_t> integers;
    int columns = 1;
  };
  std::map<std::string, Entry, std::less<>> entries;

  /// Adds the parts of another rank: sums to one row, lists behind each other.
  void add(const StateNumbers& other);
  /// Leaves nothing of what one rank has for all.
  void forget_parts();

  [[nodiscard]] std::vector<char> packed() const;
  static StateNumbers unpacked(const std::vector<char>& bytes);
};

class NumbersWriter final : public Archive {
 public:
  explicit NumbersWriter(StateNumbers& to) : to_(&to) {}
  bool loading() const override { return false; }
  void number(std::string_view name, double& value) override { reals(name, {value}, Kind::same); }
  void integer(std::string_view name, std::int64_t& value) override {
    whole(name, {value}, Kind::same);
  }
  void numbers(std::string_view name, std::vector<double>& values) override {
    reals(name, values, Kind::same);
  }
  void integers(std::string_view name, std::vector<std::int64_t>& values) override {
    whole(name, values, Kind::same);
  }
  void sums(std::string_view name, std::vector<double>& values, int columns) override;
  void total(std::string_view name, std::int64_t& value) override {
    whole(name, {value}, Kind::sum);
  }
  void total(std::string_view name, double& value) override { reals(name, {value}, Kind::sum); }
  void list(std::string_view name, std::vector<double>& values) override {
    reals(name, values, Kind::list);
  }
  void rows(std::string_view name, std::vector<double>& values) override {
    reals(name, values, Kind::rows);
  }

 private:
  using Kind = StateNumbers::Kind;
  void reals(std::string_view name, std::vector<double> values, Kind kind, int columns = 1);
  void whole(std::string_view name, std::vector<std::int64_t> values, Kind kind);
  StateNumbers* to_;
};

class NumbersReader final : public Archive {
 public:
  explicit NumbersReader(const StateNumbers& from) : from_(&from) {}
  bool loading() const override { return true; }
  void number(std::string_view name, double& value) override { value = entry(name).reals.at(0); }
  void integer(std::string_view name, std::int64_t& value) override {
    value = entry(name).integers.at(0);
  }
  void numbers(std::string_view name, std::vector<double>& values) override {
    values = entry(name).reals;
  }
  void integers(std::string_view name, std::vector<std::int64_t>& values) override {
    values = entry(name).integers;
  }

 private:
  const StateNumbers::Entry& entry(std::string_view name) const {
    const auto found = from_->entries.find(name);
    if (found == from_->entries.end())
      throw std::logic_error("state '" + std::string(name) + "' was never archived");
    return found->second;
  }
  const StateNumbers* from_;
};

}  // namespace breccia
