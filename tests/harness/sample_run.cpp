#include "harness/sample_run.hpp"

#include "io/csv.hpp"
#include "io/frame_series.hpp"
#include "io/report.hpp"
#include "io/run_folder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace breccia {
namespace {

constexpr double kRadius = 0.025;  // m
constexpr std::int32_t kInserted = 1, kReleased = 2;

// Point k of ring r of a disc with 8 r points on ring r.
std::int32_t ring_point(int r, int k) {
  return r == 0 ? 0 : 1 + 4 * r * (r - 1) + k % (8 * r);
}

void add_ring_of_points(SampleState& s, double radius, int count) {
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * k / count;
    s.points.push_back(radius * std::cos(angle));
    s.points.push_back(radius * std::sin(angle));
  }
}

void add_triangle(SampleState& s, std::int32_t a, std::int32_t b, std::int32_t c) {
  s.cells.push_back(a);
  s.cells.push_back(b);
  s.cells.push_back(c);
}

// An eighth of the triangles between rings r and r + 1.
void add_sector(SampleState& s, int r, int sector) {
  for (int k = 0; k <= r; ++k) {
    const int inner = sector * r + k, outer = sector * (r + 1) + k;
    const std::int32_t here = ring_point(r, inner), out = ring_point(r + 1, outer + 1);
    add_triangle(s, here, ring_point(r + 1, outer), out);
    if (k < r) add_triangle(s, here, out, ring_point(r, inner + 1));
  }
}

void add_disc_mesh(SampleState& s, int rings) {
  for (int r = 0; r <= rings; ++r) add_ring_of_points(s, kRadius * r / rings, std::max(8 * r, 1));
  for (int r = 0; r < rings; ++r) {
    for (int sector = 0; sector < 8; ++sector) add_sector(s, r, sector);
  }
}

// Gives the elements on the left their own nodes on the vertical diameter where the crack is.
std::vector<std::int32_t> split_diameter(SampleState& s, double half_length) {
  const std::size_t points = s.points.size() / 2;
  std::vector<std::int32_t> copy(points, -1);
  for (std::size_t n = 0; n < points; ++n) {
    if (std::abs(s.points[2 * n]) > 1e-9 || std::abs(s.points[2 * n + 1]) > half_length) continue;
    copy[n] = static_cast<std::int32_t>(s.points.size() / 2);
    const std::array<double, 2> place = {s.points[2 * n], s.points[2 * n + 1]};
    s.points.insert(s.points.end(), place.begin(), place.end());
  }
  for (std::size_t e = 0; e < s.cells.size(); e += 3) {
    double middle = 0;
    for (std::size_t a = 0; a < 3; ++a) middle += s.points[2 * std::size_t(s.cells[e + a])];
    for (std::size_t a = 0; a < 3; ++a) {
      auto& node = s.cells[e + a];
      if (middle < 0 && copy[std::size_t(node)] >= 0) node = copy[std::size_t(node)];
    }
  }
  return copy;
}

void add_crack_face(SampleState& s, double damage) {
  s.damage.push_back(damage);
  s.status.push_back(damage < 1 ? kInserted : kReleased);
  s.opening.push_back(damage * 2e-5);
  s.slip.push_back(damage * 5e-6);
}

void add_disc_cracks(SampleState& s, int rings, double half_length) {
  for (const int quarter : {1, 3}) {
    for (int r = 0; r < rings; ++r) {
      const double middle = kRadius * (r + 0.5) / rings;
      if (middle > half_length) continue;
      const auto corner = static_cast<std::int32_t>(s.crack_points.size() / 2);
      for (const int ring : {r, r + 1}) {
        const auto n = static_cast<std::size_t>(ring_point(ring, 2 * quarter * ring));
        s.crack_points.insert(s.crack_points.end(), {0.0, s.points[2 * n + 1]});
      }
      s.crack_cells.insert(s.crack_cells.end(), {corner, corner + 1});
      s.mode.push_back(middle < 0.8 * kRadius ? 1.0 : 1.8);
      add_crack_face(s, std::min(1.0, 3 * (1 - middle / half_length)));
    }
  }
}

// Stress of a disc between two point loads (textbook solution), cut off near the loads.
void add_disc_stress(SampleState& s, double load) {
  for (std::size_t e = 0; e < s.cells.size(); e += 3) {
    double x = 0, y = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      x += s.points[2 * std::size_t(s.cells[e + a])] / 3;
      y += s.points[2 * std::size_t(s.cells[e + a]) + 1] / 3;
    }
    const double scale = 2 * load / std::numbers::pi, r = kRadius;
    const double a = std::max(x * x + (r - y) * (r - y), 1e-2 * r * r);
    const double b = std::max(x * x + (r + y) * (r + y), 1e-2 * r * r);
    const double xx = scale * (0.5 / r - (r - y) * x * x / (a * a) - (r + y) * x * x / (b * b));
    const double yy =
        scale * (0.5 / r - std::pow(r - y, 3) / (a * a) - std::pow(r + y, 3) / (b * b));
    const double xy = scale * ((r - y) * (r - y) * x / (a * a) - (r + y) * (r + y) * x / (b * b));
    s.stress.insert(s.stress.end(), {xx, yy, xy, 0.25 * (xx + yy)});
    s.body.push_back(0);
  }
}

// Squeezes the disc and pushes its halves apart where nodes were split; `copy` as split_diameter
// gave it.
void move_disc(SampleState& s, const std::vector<std::int32_t>& copy, double progress,
               double cracked) {
  const std::size_t nodes = s.points.size() / 2;
  s.displacement.resize(s.points.size());
  s.velocity.resize(s.points.size());
  for (std::size_t n = 0; n < nodes; ++n) {
    const double x = s.points[2 * n], y = s.points[2 * n + 1];
    double side = x > 0 ? 1 : -1;
    if (std::abs(x) < 1e-9) side = n >= copy.size() ? -1 : copy[n] < 0 ? 0 : 1;
    s.displacement[2 * n] = 2e-3 * progress * x + side * 4e-4 * cracked * cracked;
    s.displacement[2 * n + 1] = -6e-3 * progress * y;
    s.velocity[2 * n] = 2 * side * cracked + x;
    s.velocity[2 * n + 1] = -0.1 * y / kRadius;
  }
  for (std::size_t i = 0; i < s.points.size(); ++i) s.points[i] += s.displacement[i];
}

void add_cube(SampleState& s, const std::array<std::int32_t, 8>& c) {
  // Six tetrahedra around the diagonal 0-7 (corner numbers in binary: x + 2 y + 4 z).
  constexpr int tets[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                              {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
  for (const auto& tet : tets) {
    for (const int k : tet) s.cells.push_back(c[static_cast<std::size_t>(k)]);
  }
}

// The beam is made of two halves that share no nodes, so that the crack may open.
void add_half_beam(SampleState& s, int cells, double edge, double sign, std::int32_t body) {
  const auto first = static_cast<std::int32_t>(s.points.size() / 3);
  const int nx = 3 * cells;
  const auto node = [&](int i, int j, int k) {
    return first + static_cast<std::int32_t>((k * (cells + 1) + j) * (nx + 1) + i);
  };
  for (int k = 0; k <= cells; ++k) {
    for (int j = 0; j <= cells; ++j) {
      for (int i = 0; i <= nx; ++i)
        s.points.insert(s.points.end(), {sign * i * edge, j * edge, k * edge});
    }
  }
  for (int k = 0; k < cells; ++k) {
    for (int j = 0; j < cells; ++j) {
      for (int i = 0; i < nx; ++i) {
        std::array<std::int32_t, 8> corners;
        for (int c = 0; c < 8; ++c) {
          const int di = sign > 0 ? c & 1 : 1 - (c & 1);
          corners[static_cast<std::size_t>(c)] = node(i + di, j + (c >> 1 & 1), k + (c >> 2));
        }
        add_cube(s, corners);
        for (int t = 0; t < 6; ++t) s.body.push_back(body);
      }
    }
  }
}

std::vector<std::string> history_columns() {
  return {"time",     "step",     "dt",          "KE",        "W_ext",   "IE_elastic", "IF_stored",
          "IF_G1",    "IF_G2",    "IF_friction", "CT_stored", "RES_1",   "RES_2",      "bonded",
          "inserted", "released", "fragments",   "load.y",    "gauge.ux"};
}

std::array<double, 19> history_row(int k, int rows) {
  const double p = static_cast<double>(k) / (rows - 1);
  const double load = p < 0.7 ? p / 0.7 : std::max(0.05, 1 - 18 * (p - 0.7));
  const double work = 2 * std::min(p, 0.72) * std::min(p, 0.72), elastic = load * load;
  const double broken = std::max(0.0, 0.9 * (work - elastic)) * (p > 0.7 ? 1 : 0.02);
  const double kinetic = std::max(0.0, work - elastic - 1.25 * broken);
  return {1e-3 * p,
          10.0 * k,
          1e-7,
          kinetic,
          work,
          elastic,
          0.02 * elastic,
          0.8 * broken,
          0.2 * broken,
          0.2 * broken,
          0.05 * broken,
          1e-15 * k,
          1e-4 * p,
          p > 0.7 ? 2960.0 : 3000.0,
          30.0 * p,
          p > 0.7 ? 40.0 : 0.0,
          p > 0.7 ? 2.0 : 1.0,
          -62e3 * load,
          1e-5 * p};
}

Report sample_report(const std::string& kind, const std::array<double, 19>& last) {
  Report report;
  report.title = kind == "disc" ? "Brazilian disc, granite, 50 mm" : "Cantilever beam";
  report.status = "complete";
  report.steps = 3000;
  report.time = last[0];
  report.ledger = {
      {"KE", last[3]}, {"W_ext", last[4]}, {"IE_elastic", last[5]}, {"IF_G1", last[7]}};
  report.res_1 = last[11];
  report.res_2 = last[12];
  report.effects = {{"solid", 3.1, 5 << 20, 3000}, {"fracture", 0.4, 1 << 20, 3000}};
  report.checks = {{"tensile strength", 7.9e6, 8e6, 0.1, true, true, "Pa", ""}};
  return report;
}

}  // namespace

Frame SampleState::frame(double time, std::int64_t step) const {
  Frame frame;
  frame.dimension = dimension;
  frame.points = points;
  frame.cell = dimension == 2 ? CellType::triangle : CellType::tetrahedron;
  frame.connectivity = cells;
  frame.point_arrays = {{"displacement", "m", dimension, std::span<const double>(displacement)},
                        {"velocity", "m/s", dimension, std::span<const double>(velocity)}};
  frame.cell_arrays = {{"body", "1", 1, std::span<const std::int32_t>(body)}};
  if (!stress.empty()) {
    frame.cell_arrays.push_back({"stress", "Pa", 4, std::span<const double>(stress)});
  }
  frame.time = time;
  frame.step = step;
  return frame;
}

CrackFrame SampleState::cracks() const {
  return {dimension, crack_points, crack_cells, damage, mode,
          opening,   slip,         status,      damage, damage};
}

SampleState sample_disc(int rings, double progress) {
  SampleState s;
  add_disc_mesh(s, rings);
  const double cracked = std::max(0.0, (progress - 0.5) / 0.5);
  add_disc_stress(s, 62e3 * std::min(2 * progress, 1.0) * (1 - 0.9 * cracked));
  const double half_length = cracked > 0 ? cracked * kRadius * 1.01 : -1;
  const std::vector<std::int32_t> copy = split_diameter(s, half_length);
  if (half_length > 0) add_disc_cracks(s, rings, half_length);
  move_disc(s, copy, progress, cracked);
  return s;
}

SampleState sample_beam(int cells, double progress) {
  SampleState s;
  s.dimension = 3;
  const double edge = 0.1 / cells;
  add_half_beam(s, cells, edge, 1, 0);
  add_half_beam(s, cells, edge, -1, 1);
  const std::size_t half = s.points.size() / 2;
  s.displacement.resize(s.points.size());
  s.velocity.assign(s.points.size(), 0);
  for (std::size_t i = 0; i < s.points.size(); i += 3) {
    const double x = std::abs(s.points[i]), angle = 0.15 * progress;
    s.displacement[i + 2] = -angle * x;
    s.displacement[i] = angle * s.points[i + 2] * (i < half ? 1 : -1);
    s.velocity[i + 2] = -10 * x * progress;
  }
  for (std::size_t i = 0; i < s.points.size(); ++i) s.points[i] += s.displacement[i];
  for (int k = 0; k < cells && progress > 0.3; ++k) {
    const auto corner = static_cast<std::int32_t>(s.crack_points.size() / 3);
    const double z = 0.1 - (k + 1) * edge, top = z + edge;
    s.crack_points.insert(s.crack_points.end(), {0, 0, z, 0, 0.1, z, 0, 0.1, top, 0, 0, top});
    s.crack_cells.insert(s.crack_cells.end(),
                         {corner, corner + 1, corner + 2, corner, corner + 2, corner + 3});
    for (int t = 0; t < 2; ++t) {
      s.mode.push_back(k + 1 < cells ? 1 : 2);
      add_crack_face(s, k + 1 < cells ? 1 : 0.6);
    }
  }
  return s;
}

void write_sample_run(const std::string& path, const std::string& kind, int frames) {
  const RunFolder folder(path, ExistingFolder::overwrite);
  folder.write_scene("title = \"" + kind + "\"\n");
  FrameSeries series(folder.path());
  for (int k = 0; k < frames; ++k) {
    const double p = frames > 1 ? static_cast<double>(k) / (frames - 1) : 1;
    const SampleState s = kind == "disc" ? sample_disc(24, p) : sample_beam(6, p);
    series.write(s.frame(1e-3 * p, 1000 * k),
                 {{SideKind::cracks, as_frame(s.cracks(), 1e-3 * p, 1000 * k)}});
  }
  constexpr int rows = 300;
  HistoryWriter history(folder.history(), history_columns());
  for (int k = 0; k < rows; ++k) history.write(history_row(k, rows));
  EventWriter events(folder.events(), kind == "disc" ? 2 : 3);
  const CrackEvent event = {7e-4, {0, 0, 0}, {1, 0, 0}, 1e-3, 1.1, 0.05, 0.01, 2e-5, 5e-6, 1e3};
  events.write(std::array{event});
  write_report(sample_report(kind, history_row(rows - 1, rows)), folder.report());
}

}  // namespace breccia
