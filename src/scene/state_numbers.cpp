#include "scene/state_numbers.hpp"

#include <algorithm>

namespace breccia {

void NumbersWriter::reals(std::string_view name, std::vector<double> values, Kind kind,
                          int columns) {
  StateNumbers::Entry& entry = to_->entries[std::string(name)];
  entry.kind = kind;
  entry.reals = std::move(values);
  entry.columns = columns;
}

void NumbersWriter::whole(std::string_view name, std::vector<std::int64_t> values, Kind kind) {
  StateNumbers::Entry& entry = to_->entries[std::string(name)];
  entry.kind = kind;
  entry.whole_numbers = true;
  entry.integers = std::move(values);
}

void NumbersWriter::sums(std::string_view name, std::vector<double>& values, int columns) {
  std::vector<double> total(static_cast<std::size_t>(columns), 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) total[i % total.size()] += values[i];
  reals(name, std::move(total), Kind::sum, columns);
}

void StateNumbers::add(const StateNumbers& other) {
  for (const auto& [name, more] : other.entries) {
    Entry& entry = entries[name];
    if (more.kind == Kind::sum) {
      for (std::size_t i = 0; i < entry.reals.size(); ++i) entry.reals[i] += more.reals[i];
      for (std::size_t i = 0; i < entry.integers.size(); ++i) entry.integers[i] += more.integers[i];
    } else if (more.kind != Kind::same) {
      entry.reals.insert(entry.reals.end(), more.reals.begin(), more.reals.end());
    }
  }
}

void StateNumbers::forget_parts() {
  for (auto& [name, entry] : entries) {
    if (entry.kind == Kind::sum) {
      std::fill(entry.reals.begin(), entry.reals.end(), 0.0);
      std::fill(entry.integers.begin(), entry.integers.end(), 0);
    } else if (entry.kind == Kind::list) {
      entry.reals.clear();
    }
  }
}

namespace {

template <class T>
void push(std::vector<char>& bytes, const T* values, std::size_t n) {
  const auto* begin = reinterpret_cast<const char*>(values);
  bytes.insert(bytes.end(), begin, begin + n * sizeof(T));
}

template <class T>
std::vector<T> pull(const char*& at, std::size_t n) {
  std::vector<T> values(n);
  std::memcpy(values.data(), at, n * sizeof(T));
  at += n * sizeof(T);
  return values;
}

}  // namespace

/// Only what each rank has a part of: the rest is the same everywhere.
std::vector<char> StateNumbers::packed() const {
  std::vector<char> bytes;
  for (const auto& [name, entry] : entries) {
    if (entry.kind == Kind::same) continue;
    const std::int64_t head[] = {static_cast<std::int64_t>(name.size()),
                                 static_cast<std::int64_t>(entry.kind), entry.whole_numbers ? 1 : 0,
                                 static_cast<std::int64_t>(entry.reals.size()),
                                 static_cast<std::int64_t>(entry.integers.size())};
    push(bytes, head, std::size(head));
    push(bytes, name.data(), name.size());
    push(bytes, entry.reals.data(), entry.reals.size());
    push(bytes, entry.integers.data(), entry.integers.size());
  }
  return bytes;
}

StateNumbers StateNumbers::unpacked(const std::vector<char>& bytes) {
  StateNumbers numbers;
  const char* at = bytes.data();
  while (at != bytes.data() + bytes.size()) {
    const auto head = pull<std::int64_t>(at, 5);
    const auto name = pull<char>(at, static_cast<std::size_t>(head[0]));
    Entry& entry = numbers.entries[std::string(name.begin(), name.end())];
    entry.kind = static_cast<Kind>(head[1]);
    entry.whole_numbers = head[2] != 0;
    entry.reals = pull<double>(at, static_cast<std::size_t>(head[3]));
    entry.integers = pull<std::int64_t>(at, static_cast<std::size_t>(head[4]));
  }
  return numbers;
}

}  // namespace breccia
