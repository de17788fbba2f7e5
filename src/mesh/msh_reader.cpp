#include "mesh/msh_reader.hpp"

#include "mesh/refusal.hpp"
#include "mesh/text_scanner.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

namespace breccia {
namespace {

constexpr long long kMost = std::numeric_limits<Index>::max();

class MshReader {
 public:
  explicit MshReader(const std::string& path) : in_(path) {}

  RawMesh read() {
    bool nodes = false;
    bool elements = false;
    while (!in_.at_end()) {
      const std::string section(in_.word());
      if (section.size() < 2 || section[0] != '$') in_.fail("a section ($...) should begin here");
      if (section == "$MeshFormat") {
        version_ = in_.number();
      } else if (section == "$PhysicalNames") {
        read_names();
      } else if (section == "$Entities") {
        read_entities();
      } else if (section == "$Nodes") {
        version_ < 4 ? read_nodes2() : read_nodes4();
        nodes = true;
      } else if (section == "$Elements") {
        if (!nodes) in_.fail("$Elements comes before $Nodes");
        version_ < 4 ? read_elements2() : read_elements4();
        elements = true;
      } else if (section == "$ElementData") {
        if (!elements) in_.fail("$ElementData comes before $Elements");
        read_field();
      }
      in_.skip_past("$End" + section.substr(1));
    }
    if (!nodes || !elements) in_.fail("the file has no $Nodes or no $Elements");
    finish_groups();
    return std::move(raw_);
  }

 private:
  using Key = std::pair<int, long long>;  // dimension and tag

  void read_names() {
    const long long count = in_.integer(0, kMost, "number of names");
    for (long long n = 0; n < count; ++n) {
      const int dimension = static_cast<int>(in_.integer(0, 3, "dimension"));
      const long long tag = in_.integer();
      names_[{dimension, tag}] = in_.word();
    }
  }

  void read_entities() {
    std::array<long long, 4> count;
    for (auto& n : count) n = in_.integer(0, kMost, "number of entities");
    for (int dimension = 0; dimension < 4; ++dimension) {
      for (long long n = 0; n < count[dimension]; ++n) {
        const long long tag = in_.integer();
        for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) in_.number();
        auto& groups = physical_[{dimension, tag}];
        groups.resize(in_.integer(0, in_.remaining(), "number of groups"));
        for (auto& g : groups) g = std::abs(in_.integer());
        if (dimension == 0) continue;
        const long long bounds = in_.integer(0, kMost, "number of boundaries");
        for (long long i = 0; i < bounds; ++i) in_.integer();
      }
    }
  }

  void add_point(long long tag, const Point<3>& x) {
    if (!number_.emplace(tag, static_cast<Index>(raw_.point.size())).second) {
      in_.fail("node " + std::to_string(tag) + " is listed twice");
    }
    raw_.point.push_back(x);
  }

  Point<3> position() {
    const double x = in_.number();
    const double y = in_.number();
    return {x, y, in_.number()};
  }

  void read_nodes2() {
    const long long count = in_.integer(1, kMost, "number of nodes");
    for (long long n = 0; n < count; ++n) {
      const long long tag = in_.integer();
      add_point(tag, position());
    }
  }

  void read_nodes4() {
    const long long blocks = in_.integer(1, kMost, "number of blocks");
    for (int i = 0; i < 3; ++i) in_.integer();  // nodes in all, smallest and largest tag
    for (long long b = 0; b < blocks; ++b) {
      const int dimension = static_cast<int>(in_.integer(0, 3, "dimension"));
      in_.integer();  // entity
      const bool parametric = in_.integer(0, 1, "parametric flag") == 1;
      std::vector<long long> tags(in_.integer(0, in_.remaining(), "number of nodes"));
      for (auto& tag : tags) tag = in_.integer();
      for (long long tag : tags) {
        add_point(tag, position());
        for (int i = 0; parametric && i < dimension; ++i) in_.number();
      }
    }
  }

  Index node() {
    const long long tag = in_.integer();
    const auto found = number_.find(tag);
    if (found == number_.end()) {
      in_.fail("an element uses node " + std::to_string(tag) + ", which does not exist");
    }
    return found->second;
  }

  Index add_element(long long tag, const GmshType& type) {
    RawElement element{type.dimension, {}};
    for (int a = 0; a <= type.dimension; ++a) element.point[a] = node();
    for (int m = 0; m < type.middles; ++m) {
      const auto [a, b] = type.edge[m];
      add_middle(raw_, element.point[a], element.point[b], node(), in_.path());
    }
    raw_.element.push_back(element);
    tags_.push_back(tag);
    return static_cast<Index>(raw_.element.size() - 1);
  }

  GmshType element_type() {
    const long long number = in_.integer();
    const GmshType type = gmsh_type(number);
    if (type.dimension >= 0) return type;
    refuse(in_.path(), "it has elements of Gmsh type " + std::to_string(number), kTypesTaken);
  }

  void read_elements2() {
    const long long count = in_.integer(1, kMost, "number of elements");
    for (long long n = 0; n < count; ++n) {
      const long long number = in_.integer();
      const GmshType type = element_type();
      const long long tags = in_.integer(0, 1000, "number of tags");
      long long group = 0;
      for (long long t = 0; t < tags; ++t) {
        const long long tag = in_.integer();
        if (t == 0) group = std::abs(tag);
      }
      const Index e = add_element(number, type);
      if (group != 0) groups_[{type.dimension, group}].push_back(e);
    }
  }

  void read_elements4() {
    const long long blocks = in_.integer(1, kMost, "number of blocks");
    for (int i = 0; i < 3; ++i) in_.integer();  // elements in all, smallest and largest tag
    for (long long b = 0; b < blocks; ++b) {
      in_.integer(0, 3, "dimension");
      const long long entity = in_.integer();
      const GmshType type = element_type();
      const long long count = in_.integer(0, kMost, "number of elements");
      const auto found = physical_.find({type.dimension, entity});
      for (long long n = 0; n < count; ++n) {
        const long long number = in_.integer();
        const Index e = add_element(number, type);
        if (found == physical_.end()) continue;
        for (long long group : found->second) groups_[{type.dimension, group}].push_back(e);
      }
    }
  }

  /// The first text is the name; of the integers the second is the number of components, the third
  /// that of the elements.
  void read_field() {
    std::string name;
    const long long texts = in_.integer(1, 1000, "number of texts");
    for (long long i = 0; i < texts; ++i) {
      const std::string text(in_.word());
      if (i == 0) name = text;
    }
    const long long reals = in_.integer(0, 1000, "number of reals");
    for (long long i = 0; i < reals; ++i) in_.number();
    const long long integers = in_.integer(3, 1000, "number of integers");
    in_.integer();  // time step
    const auto components = static_cast<int>(in_.integer(1, 9, "number of components"));
    const long long count = in_.integer(0, kMost, "number of elements");
    for (long long i = 3; i < integers; ++i) in_.integer();
    const auto n = static_cast<std::size_t>(components);
    const auto [place, fresh] = raw_.fields.try_emplace(name, ElementField{components, {}});
    if (!fresh) in_.fail("the field \"" + name + "\" is given twice");
    auto& values = place->second.values;
    values.assign(raw_.element.size() * n, std::numeric_limits<double>::quiet_NaN());
    for (long long i = 0; i < count; ++i) {
      const std::size_t at = element_of(in_.integer()) * n;
      if (!std::isnan(values[at])) in_.fail("the field has two values for this element");
      for (std::size_t c = 0; c < n; ++c) {
        values[at + c] = in_.number();
        if (!std::isfinite(values[at + c])) in_.fail("the value is no finite number");
      }
    }
  }

  std::size_t element_of(long long tag) {
    if (element_.empty())
      for (std::size_t e = 0; e < tags_.size(); ++e) element_.emplace(tags_[e], e);
    const auto found = element_.find(tag);
    if (found == element_.end())
      in_.fail("the field has a value for element " + std::to_string(tag) +
               ", which does not exist");
    return found->second;
  }

  void finish_groups() {
    for (auto& [key, elements] : groups_) {
      const auto name = names_.find(key);
      raw_.groups.push_back({key.first,
                             name == names_.end() ? std::to_string(key.second) : name->second,
                             std::move(elements)});
    }
  }

  TextScanner in_;
  double version_ = 0;
  RawMesh raw_;
  std::unordered_map<long long, Index> number_;
  std::vector<long long> tags_;  // of the elements
  std::unordered_map<long long, std::size_t> element_;
  std::map<Key, std::string> names_;
  std::map<Key, std::vector<long long>> physical_;
  std::map<Key, std::vector<Index>> groups_;
};

}  // namespace

bool is_ascii_msh(const std::string& path) {
  TextScanner in(path);
  if (in.at_end() || in.word() != "$MeshFormat") {
    refuse(path, "it is not a Gmsh mesh file", "give a .msh, .geo or .h5 mesh file");
  }
  const double version = in.number();
  const long long binary = in.integer(0, 1, "file type");
  return binary == 0 && ((version >= 2 && version < 3) || version == 4.1);
}

RawMesh read_msh(const std::string& path) {
  return MshReader(path).read();
}

}  // namespace breccia
