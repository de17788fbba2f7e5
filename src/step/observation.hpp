#pragma once
#include "base/index.hpp"
#include "core/world.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace breccia {

/// A row of the history is taken in two moments of one step: `before` the nodes move (positions
/// and stresses at t^n, velocities at t^(n-1/2)) and `after` (velocities at t^(n+1/2),
/// reactions). Velocities at t^n are the mean of both.
enum class Moment { before, after };

/// How the numbers that the ranks have for a column become one.
enum class Merge { same, sum, largest };

/// One history row in the making: columns in the order in which they were first set.
class Row {
 public:
  /// A column keeps a merge that it was once given.
  void set(const std::string& column, double value, Merge merge = Merge::same);
  double get(const std::string& column) const;  ///< 0 where it is not set yet
  const std::vector<std::string>& columns() const { return columns_; }
  const std::vector<double>& values() const { return values_; }
  void restart_row();  ///< keeps the columns, zeroes the values
  /// The row of the whole scene. All ranks have the same columns. Collective.
  void merge(const World& world);

 private:
  std::vector<std::string> columns_;
  std::vector<double> values_;
  std::vector<Merge> merges_;
};

/// Fields of a frame. `components` numbers per entity, entity-major.
struct PictureField {
  std::string name;
  std::string unit;
  int components = 1;
  std::vector<double> values;
};

/// A surface inside the solid that opened: an inserted or released face, for pictures.
struct CrackFace {
  double point[3][3];  ///< corners of the mid-surface: 2 (2D) or 3 (3D) points
  Index family[3];     ///< points of the mesh that these corners were
  double damage, opening, slip;
  double mode;  ///< 1 tension ... 2 shear
  int status;   ///< face_status
  double area;
  double energy;  ///< J, that breaking it has cost so far
  double time;    ///< s, when it broke; -1 while it holds
};

/// A point of one element's face that presses on another element, for pictures.
struct Touch {
  double place[3];  ///< m
  double force[3];  ///< N, on the element of the face
  Index element, target;
};

/// Where something is deepest in something else.
struct Overlap {
  double share = 0;  ///< depth over the height of the elements at the face; 0: nothing overlaps
  Index element = kNone;
};

/// What modules draw on for one frame.
struct Picture {
  std::vector<PictureField> node_fields;
  std::vector<PictureField> element_fields;
  std::vector<CrackFace> cracks;
  std::vector<Touch> touches;
};

/// One broken face, for events.csv.
struct Event {
  double time;
  double place[3];
  double normal[3];
  double mode;                          ///< 1 tension ... 2 shear
  double area;                          ///< m2
  double energy_tension, energy_shear;  ///< J
  double opening, slip;                 ///< m, across and along the face
  double moment;                        ///< N m, scalar seismic moment
};

/// Counts that the report and the checks ask for.
struct Counts {
  std::int64_t bonded = 0, inserted = 0, released = 0;
  std::int64_t contact_points = 0;
};

/// State of a module that is not in the store: named numbers for a checkpoint. Those of the first
/// four are the same on all ranks; of the others each rank has its part.
class Archive {
 public:
  virtual ~Archive() = default;
  virtual bool loading() const = 0;
  virtual void number(std::string_view name, double& value) = 0;
  virtual void integer(std::string_view name, std::int64_t& value) = 0;
  virtual void numbers(std::string_view name, std::vector<double>& values) = 0;
  virtual void integers(std::string_view name, std::vector<std::int64_t>& values) = 0;

  /// Running sums, `columns` in a row: only the sum of all rows of all ranks counts.
  virtual void sums(std::string_view name, std::vector<double>& values, int /*columns*/) {
    numbers(name, values);
  }
  virtual void total(std::string_view name, std::int64_t& value) { integer(name, value); }
  virtual void total(std::string_view name, double& value) { number(name, value); }
  /// A list that goes on with those of the other ranks.
  virtual void list(std::string_view name, std::vector<double>& values) { numbers(name, values); }
  /// The same, of which each rank may want any part again.
  virtual void rows(std::string_view name, std::vector<double>& values) { numbers(name, values); }
};

}  // namespace breccia
