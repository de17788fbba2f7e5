#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace breccia {

/// A table in a text file: one line of column names, then rows of numbers that read back exactly.
/// Rows are only appended; a run that is taken up again cuts the file to the rows of its
/// checkpoint, so that the file of an interrupted run equals that of an uninterrupted one byte for
/// byte. All functions throw Error (disk full, no permission, a file that does not fit).
class CsvTable {
 public:
  /// Starts a new table; an old file of this name is replaced.
  CsvTable(std::string path, std::vector<std::string> columns);
  /// Goes on with an existing table after its first `rows` rows; what follows them is cut off.
  CsvTable(std::string path, std::vector<std::string> columns, std::int64_t rows);
  ~CsvTable();
  CsvTable(const CsvTable&) = delete;
  CsvTable& operator=(const CsvTable&) = delete;

  /// Appends one row, one value per column (std::logic_error otherwise). It reaches the file with
  /// `flush`.
  void row(std::span<const double> values);
  /// Hands all rows to the system, so that other programs see them and a crash of this one loses
  /// nothing.
  void flush();
  /// Forces all rows to the disk; call before a checkpoint is published.
  void sync();

  [[nodiscard]] std::int64_t rows() const { return rows_; }
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }

 private:
  void cut_after(std::int64_t rows);

  std::string path_;
  std::vector<std::string> columns_;
  std::string waiting_;  ///< text not yet handed to the system
  std::int64_t rows_ = 0;
  int file_ = -1;
};

/// history.csv: one row per history interval, seen by others at once.
class HistoryWriter {
 public:
  HistoryWriter(std::string path, std::vector<std::string> columns)
      : table_(std::move(path), std::move(columns)) {}
  HistoryWriter(std::string path, std::vector<std::string> columns, std::int64_t rows)
      : table_(std::move(path), std::move(columns), rows) {}
  void write(std::span<const double> values) {
    table_.row(values);
    table_.flush();
  }
  void sync() { table_.sync(); }
  [[nodiscard]] std::int64_t rows() const { return table_.rows(); }

 private:
  CsvTable table_;
};

/// One released interface.
struct CrackEvent {
  double time = 0;                   ///< [s]
  std::array<double, 3> place = {};  ///< [m] middle of the face; `dimension` components are written
  std::array<double, 3> normal = {};            ///< unit vector, likewise
  double area = 0;                              ///< [m2]
  double mode = 1;                              ///< 1 tension ... 2 shear
  double energy_tension = 0, energy_shear = 0;  ///< [J]
  double opening = 0, slip = 0;                 ///< [m]
  double moment = 0;                            ///< [N m] scalar seismic moment
};

/// The first rows of an events.csv.
std::vector<CrackEvent> read_events(const std::string& path, int dimension, std::int64_t rows);

/// events.csv: one row per released interface, in the order given.
class EventWriter {
 public:
  EventWriter(std::string path, int dimension);
  EventWriter(std::string path, int dimension, std::int64_t rows);
  void write(std::span<const CrackEvent> events);
  void sync() { table_.sync(); }
  [[nodiscard]] std::int64_t rows() const { return table_.rows(); }

 private:
  int dimension_;
  CsvTable table_;
};

/// Breaks near one another in space and time: what a sensor of acoustic emission hears as one.
struct EmissionRow {
  double time = 0, duration = 0;     ///< [s] of the first break; until the last one
  std::array<double, 3> place = {};  ///< [m] centre of the energy
  std::int64_t breaks = 0;
  double area = 0;       ///< [m2]
  double mode = 1;       ///< 1 tension ... 2 shear
  double energy = 0;     ///< [J] that breaking has cost
  double moment = 0;     ///< [N m]
  double magnitude = 0;  ///< moment magnitude
};

/// emissions.csv, written as a whole. Throws Error.
void write_emissions(const std::string& path, int dimension, std::span<const EmissionRow> rows);

/// One connected piece of solid.
struct FragmentRow {
  std::int64_t fragment = 0;  ///< number in this frame, by falling mass
  std::int64_t elements = 0;
  double mass = 0;                   ///< [kg]
  double size = 0;                   ///< [m] edge of the square or cube of the same area or volume
  std::array<double, 3> place = {};  ///< [m] centre of mass
  std::array<double, 3> velocity = {};  ///< [m/s] of the centre of mass
  std::array<double, 3> spin = {};      ///< [rad/s]; in the plane only the last one
  double length = 0, width = 0;  ///< [m] longest and shortest edge of the brick that turns alike
};

/// fragments.csv: every fragment at every frame.
class FragmentWriter {
 public:
  FragmentWriter(std::string path, int dimension);
  FragmentWriter(std::string path, int dimension, std::int64_t rows);
  void write(double time, std::int64_t frame, std::span<const FragmentRow> fragments);
  void sync() { table_.sync(); }
  [[nodiscard]] std::int64_t rows() const { return table_.rows(); }

 private:
  int dimension_;
  CsvTable table_;
};

}  // namespace breccia
