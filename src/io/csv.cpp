#include "io/csv.hpp"

#include "io/aside_file.hpp"
#include "io/number.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace breccia {
namespace {

std::string header_line(const std::vector<std::string>& columns) {
  std::string line;
  for (const std::string& column : columns) {
    if (!line.empty()) line += ',';
    const bool plain = column.find_first_of(",\"\n") == std::string::npos;
    if (plain) {
      line += column;
    } else {  // RFC 4180: quoted, inner quotes doubled
      line += '"';
      for (const char c : column) line += c == '"' ? std::string(2, c) : std::string(1, c);
      line += '"';
    }
  }
  return line + '\n';
}

// Reads at `offset` until the buffer is full or the file ends; returns the bytes read.
std::size_t read_at(int file, const std::string& path, std::span<char> buffer, off_t offset) {
  std::size_t done = 0;
  while (done < buffer.size()) {
    const ssize_t n = ::pread(file, buffer.data() + done, buffer.size() - done,
                              offset + static_cast<off_t>(done));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw file_error(path, "read", errno);
    if (n == 0) break;
    done += static_cast<std::size_t>(n);
  }
  return done;
}

void add_place(std::vector<std::string>& names, const std::string& stem, int dimension) {
  for (int d = 0; d < dimension; ++d) names.push_back(stem + "xyz"[d]);
}

void add_vector(std::vector<double>& row, const std::array<double, 3>& vector, int dimension) {
  row.insert(row.end(), vector.begin(), vector.begin() + dimension);
}

std::vector<std::string> event_columns(int dimension) {
  std::vector<std::string> names = {"time"};
  add_place(names, "", dimension);
  add_place(names, "normal_", dimension);
  names.insert(names.end(),
               {"area", "mode", "energy_tension", "energy_shear", "opening", "slip", "moment"});
  return names;
}

std::vector<std::string> fragment_columns(int dimension) {
  std::vector<std::string> names = {"time", "frame", "fragment", "elements", "mass", "size"};
  add_place(names, "", dimension);
  add_place(names, "velocity_", dimension);
  if (dimension == 3)
    add_place(names, "spin_", dimension);
  else
    names.emplace_back("spin");
  names.insert(names.end(), {"length", "width"});
  return names;
}

std::vector<std::string> emission_columns(int dimension) {
  std::vector<std::string> names = {"time", "duration"};
  add_place(names, "", dimension);
  names.insert(names.end(), {"breaks", "area", "mode", "energy", "moment", "magnitude"});
  return names;
}

}  // namespace

CsvTable::CsvTable(std::string path, std::vector<std::string> columns)
    : path_(std::move(path)), columns_(std::move(columns)), waiting_(header_line(columns_)) {
  file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file_ < 0) throw file_error(path_, "create the file", errno);
  flush();
}

CsvTable::CsvTable(std::string path, std::vector<std::string> columns, std::int64_t rows)
    : path_(std::move(path)), columns_(std::move(columns)), rows_(rows) {
  file_ = ::open(path_.c_str(), O_RDWR | O_CLOEXEC);
  if (file_ < 0) throw file_error(path_, "go on with the file", errno);
  const std::string header = header_line(columns_);
  std::string found(header.size(), '\0');
  if (read_at(file_, path_, found, 0) != found.size() || found != header) {
    throw Error(path_, "its columns are not those of this run, so it cannot be continued",
                "restore the file of the interrupted run, or start again with --overwrite");
  }
  cut_after(rows);
}

CsvTable::~CsvTable() {
  if (file_ < 0) return;
  try {
    flush();
  } catch (const Error&) {  // a destructor cannot report; every regular path has flushed before
  }
  ::close(file_);
}

void CsvTable::cut_after(std::int64_t rows) {
  std::vector<char> buffer(std::size_t{1} << 20);
  std::int64_t lines = rows + 1;  // with the header
  off_t end = 0;
  while (lines > 0) {
    const std::size_t n = read_at(file_, path_, buffer, end);
    std::size_t k = 0;
    for (; k < n && lines > 0; ++k) lines -= buffer[k] == '\n' ? 1 : 0;
    end += static_cast<off_t>(k);
    if (n == 0) {
      throw Error(path_,
                  "it has fewer rows than the checkpoint knows of (" + std::to_string(rows) + ")",
                  "restore the file of the interrupted run, or start again with --overwrite");
    }
  }
  if (::ftruncate(file_, end) != 0 || ::lseek(file_, end, SEEK_SET) != end) {
    throw file_error(path_, "cut the file", errno);
  }
}

void CsvTable::row(std::span<const double> values) {
  if (values.size() != columns_.size()) {
    throw std::logic_error(path_ + ": " + std::to_string(values.size()) + " values for " +
                           std::to_string(columns_.size()) + " columns");
  }
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (k > 0) waiting_ += ',';
    append_number(waiting_, values[k]);
  }
  waiting_ += '\n';
  ++rows_;
}

void CsvTable::flush() {
  std::size_t done = 0;
  while (done < waiting_.size()) {
    const ssize_t n = ::write(file_, waiting_.data() + done, waiting_.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      const int code = errno;
      waiting_.erase(0, done);
      throw file_error(path_, "write", code);
    }
    done += static_cast<std::size_t>(n);
  }
  waiting_.clear();
}

void CsvTable::sync() {
  flush();
  if (::fsync(file_) != 0 && errno != EINVAL) throw file_error(path_, "write to the disk", errno);
}

EventWriter::EventWriter(std::string path, int dimension)
    : dimension_(dimension), table_(std::move(path), event_columns(dimension)) {}

EventWriter::EventWriter(std::string path, int dimension, std::int64_t rows)
    : dimension_(dimension), table_(std::move(path), event_columns(dimension), rows) {}

void EventWriter::write(std::span<const CrackEvent> events) {
  std::vector<double> row;
  for (const CrackEvent& event : events) {
    row = {event.time};
    add_vector(row, event.place, dimension_);
    add_vector(row, event.normal, dimension_);
    row.insert(row.end(), {event.area, event.mode, event.energy_tension, event.energy_shear,
                           event.opening, event.slip, event.moment});
    table_.row(row);
  }
  table_.flush();
}

std::vector<CrackEvent> read_events(const std::string& path, int dimension, std::int64_t rows) {
  std::vector<CrackEvent> events;
  std::ifstream file(path);
  std::string line, cell;
  std::getline(file, line);
  for (std::int64_t r = 0; r < rows && std::getline(file, line); ++r) {
    std::vector<double> row;
    std::stringstream cells(line);
    while (std::getline(cells, cell, ',')) row.push_back(std::strtod(cell.c_str(), nullptr));
    if (row.size() != event_columns(dimension).size())
      throw Error(path, "row " + std::to_string(r + 1) + " is damaged",
                  "restore the file of the interrupted run, or start again with --overwrite");
    CrackEvent event;
    const double* at = row.data();
    event.time = *at++;
    for (int d = 0; d < dimension; ++d) event.place[d] = *at++;
    for (int d = 0; d < dimension; ++d) event.normal[d] = *at++;
    for (double* value : {&event.area, &event.mode, &event.energy_tension, &event.energy_shear,
                          &event.opening, &event.slip, &event.moment})
      *value = *at++;
    events.push_back(event);
  }
  return events;
}

void write_emissions(const std::string& path, int dimension, std::span<const EmissionRow> rows) {
  CsvTable table(path, emission_columns(dimension));
  std::vector<double> row;
  for (const EmissionRow& one : rows) {
    row = {one.time, one.duration};
    add_vector(row, one.place, dimension);
    row.insert(row.end(), {static_cast<double>(one.breaks), one.area, one.mode, one.energy,
                           one.moment, one.magnitude});
    table.row(row);
  }
  table.flush();
}

FragmentWriter::FragmentWriter(std::string path, int dimension)
    : dimension_(dimension), table_(std::move(path), fragment_columns(dimension)) {}

FragmentWriter::FragmentWriter(std::string path, int dimension, std::int64_t rows)
    : dimension_(dimension), table_(std::move(path), fragment_columns(dimension), rows) {}

void FragmentWriter::write(double time, std::int64_t frame,
                           std::span<const FragmentRow> fragments) {
  std::vector<double> row;
  for (const FragmentRow& piece : fragments) {
    row = {time,
           static_cast<double>(frame),
           static_cast<double>(piece.fragment),
           static_cast<double>(piece.elements),
           piece.mass,
           piece.size};
    add_vector(row, piece.place, dimension_);
    add_vector(row, piece.velocity, dimension_);
    row.insert(row.end(), piece.spin.begin() + (dimension_ == 3 ? 0 : 2), piece.spin.end());
    row.insert(row.end(), {piece.length, piece.width});
    table_.row(row);
  }
  table_.flush();
}

}  // namespace breccia
