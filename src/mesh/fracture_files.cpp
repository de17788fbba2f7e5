#include "mesh/fracture_files.hpp"

#include "mesh/refusal.hpp"

#include <cctype>
#include <charconv>
#include <fstream>
#include <map>

namespace breccia {
namespace {

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t\r");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

/// A text file line by line.
class Lines {
 public:
  explicit Lines(const std::string& path) : path_(path), file_(path) {
    if (!file_) refuse(path, "the file cannot be read", "check its name and that you may read it");
  }
  bool next(std::string& line) {
    if (!std::getline(file_, line)) return false;
    ++number_;
    line = trimmed(line);
    return true;
  }
  double number(const std::string& text) const {
    const std::string word = trimmed(text);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size())
      fail("\"" + word + "\" is not a number");
    return value;
  }
  [[noreturn]] void fail(const std::string& cause) const {
    refuse(path_ + ":" + std::to_string(number_), cause, "see docs/modules/faults.md");
  }

 private:
  std::string path_;
  std::ifstream file_;
  long number_ = 0;
};

std::vector<FracturePiece> read_csv(const std::string& path, int dimension, double scale) {
  Lines lines(path);
  std::vector<FracturePiece> pieces;
  std::vector<Point<3>> points;
  std::string line;
  while (lines.next(line)) {
    if (line.empty()) {
      add_pieces(dimension, points, pieces);
      points.clear();
      continue;
    }
    if (line[0] == '#' || std::isalpha(static_cast<unsigned char>(line[0])) != 0) continue;
    Point<3> x{};
    int read = 0;
    for (std::size_t at = 0; at != std::string::npos; ++read) {
      const auto comma = line.find(',', at);
      if (read == dimension)
        lines.fail("more than " + std::to_string(dimension) + " numbers for a point");
      x[read] = scale * lines.number(line.substr(at, comma - at));
      at = comma == std::string::npos ? comma : comma + 1;
    }
    if (read != dimension)
      lines.fail(std::to_string(read) + " numbers; a point has " + std::to_string(dimension));
    points.push_back(x);
  }
  add_pieces(dimension, points, pieces);
  return pieces;
}

/// One entity of a DXF file: its points and flags.
struct DxfReader {
  int dimension;
  double scale;
  std::vector<FracturePiece>& pieces;
  std::string kind;
  std::vector<Point<3>> points;
  long flags = 0;

  void put(int axis, std::size_t point, double value) {
    if (points.size() <= point) points.resize(point + 1, Point<3>{});
    points[point][axis] = scale * value;
  }

  void take(int code, double value) {
    if (code == 70) flags = static_cast<long>(value);
    if (kind == "LWPOLYLINE" || kind == "VERTEX") {
      if (code == 10) points.push_back({scale * value, 0, 0});
      if ((code == 20 || code == 30) && !points.empty())
        points.back()[code / 10 - 1] = scale * value;
      return;
    }
    // 10, 20, 30 are the first point, 11, 21, 31 the second, and so on.
    const bool coordinate = code >= 10 && code <= 39 && code % 10 <= 3;
    if (coordinate && (kind == "LINE" || kind == "3DFACE"))
      put(code / 10 - 1, static_cast<std::size_t>(code % 10), value);
  }

  void finish() {
    if (kind == "3DFACE" && points.size() == 4 && points[3] == points[2]) points.pop_back();
    const bool closed = (flags & 1) != 0;
    if (dimension == 2 && closed && points.size() > 2) points.push_back(points[0]);
    if (dimension == 2 && kind == "3DFACE") points.clear();
    if (dimension == 3 && kind != "3DFACE" && !closed) points.clear();
    for (auto& x : points)
      if (dimension == 2) x[2] = 0;
    add_pieces(dimension, points, pieces);
    points.clear();
    flags = 0;
    kind.clear();
  }
};

std::vector<FracturePiece> read_dxf(const std::string& path, int dimension, double scale) {
  Lines lines(path);
  std::vector<FracturePiece> pieces;
  DxfReader reader{dimension, scale, pieces, "", {}, 0};
  std::string code, value;
  bool in_polyline = false;
  while (lines.next(code)) {
    if (!lines.next(value)) lines.fail("the file ends within a pair of code and value");
    const int number = static_cast<int>(lines.number(code));
    if (number != 0) {
      const bool real = (number >= 10 && number < 60) || number == 70;
      const bool of_header = in_polyline && reader.kind == "POLYLINE" && number != 70;
      if (!reader.kind.empty() && real && !of_header) {
        const long flags = reader.flags;
        reader.take(number, lines.number(value));
        if (reader.kind == "VERTEX") reader.flags = flags;  // those of its polyline
      }
      continue;
    }
    if (in_polyline && value == "VERTEX") {
      reader.kind = value;
      continue;
    }
    reader.finish();
    in_polyline = value == "POLYLINE";
    const bool wanted =
        value == "LINE" || value == "LWPOLYLINE" || value == "3DFACE" || in_polyline;
    reader.kind = wanted ? value : "";
  }
  reader.finish();
  return pieces;
}

}  // namespace

void add_pieces(int dimension, const std::vector<Point<3>>& points,
                std::vector<FracturePiece>& pieces) {
  if (points.empty()) return;
  if (dimension == 3) {
    pieces.push_back(points);
    return;
  }
  if (points.size() == 1) pieces.push_back(points);  // refused by check_fractures
  for (std::size_t i = 1; i < points.size(); ++i) pieces.push_back({points[i - 1], points[i]});
}

std::vector<FracturePiece> read_fractures(const std::string& path, int dimension, double scale) {
  std::string lower = path;
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  auto pieces =
      lower.ends_with(".dxf") ? read_dxf(path, dimension, scale) : read_csv(path, dimension, scale);
  if (pieces.empty())
    refuse(path, "no fracture of " + std::to_string(dimension) + " dimensions is in it",
           dimension == 2 ? "give LINE, LWPOLYLINE or POLYLINE, or a .csv of points"
                          : "give 3DFACE or closed POLYLINE, or a .csv of polygons");
  return pieces;
}

}  // namespace breccia
