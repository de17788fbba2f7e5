#include "scene/state_file.hpp"

#include "core/build_info.hpp"
#include "io/digest.hpp"
#include "scene/state_rows.hpp"

#include <fmt/format.h>

namespace breccia {

namespace {

const char* const kCounts[] = {"count.node",         "count.corner",        "count.element",
                               "count.element_word", "count.family",        "count.face",
                               "count.interface",    "count.boundary",      "count.absorber",
                               "count.material",     "count.contact_point", "count.rigid"};
static_assert(std::size(kCounts) == kEntities);

class Writer final : public Archive {
 public:
  explicit Writer(CheckpointWriter& file) : file_(&file) {}
  bool loading() const override { return false; }
  void number(std::string_view name, double& value) override {
    file_->put_number(std::string(name), value);
  }
  void integer(std::string_view name, std::int64_t& value) override {
    file_->put_number(std::string(name), value);
  }
  void numbers(std::string_view name, std::vector<double>& values) override {
    file_->put(std::string(name), values);
  }
  void integers(std::string_view name, std::vector<std::int64_t>& values) override {
    file_->put(std::string(name), values);
  }

 private:
  CheckpointWriter* file_;
};

class Reader final : public Archive {
 public:
  explicit Reader(const CheckpointReader& file) : file_(&file) {}
  bool loading() const override { return true; }
  void number(std::string_view name, double& value) override {
    value = file_->real(std::string(name));
  }
  void integer(std::string_view name, std::int64_t& value) override {
    value = file_->integer(std::string(name));
  }
  void numbers(std::string_view name, std::vector<double>& values) override {
    values = file_->array<double>(std::string(name));
  }
  void integers(std::string_view name, std::vector<std::int64_t>& values) override {
    values = file_->array<std::int64_t>(std::string(name));
  }

 private:
  const CheckpointReader* file_;
};

void archive(Archive& archive, OutputState& output) {
  archive.integer("output.history_rows", output.history_rows);
  archive.integer("output.event_rows", output.event_rows);
  archive.integer("output.fragment_rows", output.fragment_rows);
  archive.integer("output.next_history", output.next_history);
  archive.integer("output.next_frame", output.next_frame);
  archive.numbers("output.frame_times", output.frame_times);
  archive.number("output.wall_seconds", output.wall_seconds);
}

}  // namespace

CheckpointIdentity identity_of(const std::string& resolved_scene) {
  const BuildInfo& build = build_info();
  return {fingerprint(resolved_scene),
          fmt::format("{} {} {} {} {} {}", build.version, build.commit, build.compiler,
                      build.build_type, build.arch, Exec::name())};
}

template <int D>
void save_state(const std::string& path, const CheckpointIdentity& identity,
                Simulation<D>& simulation, const OutputState& output) {
  CheckpointWriter file(path, identity);
  Store& store = simulation.model().store;
  for (int e = 0; e < kEntities; ++e)
    file.put_number(kCounts[e], static_cast<std::int64_t>(store.count(static_cast<Entity>(e))));
  store.save([&](const FieldInfo& info, const void* data, std::size_t bytes) {
    const std::span all(static_cast<const std::uint8_t*>(data), bytes);
    file.put("field." + std::string(info.name), all);
  });
  Writer writer(file);
  simulation.archive(writer);
  OutputState copy = output;
  archive(writer, copy);
  file.commit();
}

template <int D>
OutputState load_state(const std::string& path, const CheckpointIdentity& identity,
                       Simulation<D>& simulation) {
  const CheckpointReader file(path, identity);
  Store& store = simulation.model().store;
  for (int e = 0; e < kEntities; ++e) {
    const auto entity = static_cast<Entity>(e);
    const auto count = static_cast<Index>(file.integer(kCounts[e]));
    if (count > store.capacity(entity)) store.set_size(entity, count, count + count / 4);
    store.set_count(entity, count);
  }
  store.load([&](const FieldInfo& info, void* data, std::size_t bytes) {
    file.array("field." + std::string(info.name),
               std::span(static_cast<std::uint8_t*>(data), bytes));
  });
  Reader reader(file);
  simulation.archive(reader);
  OutputState output;
  archive(reader, output);
  simulation.resume();
  return output;
}

template <int D>
std::string state_hash(const Simulation<D>& simulation) {
  Digest digest;
  const Topology<D>& topology = simulation.model().topology;
  for (const auto& [name, field] : in_order<D>(rows_of(simulation.model().store),
                                               topology.family_start, topology.family_corner)) {
    digest.update(name);
    digest.update(field.data.data(), field.data.size());
  }
  return hex16(digest.value());
}

template void save_state(const std::string&, const CheckpointIdentity&, Simulation<2>&,
                         const OutputState&);
template void save_state(const std::string&, const CheckpointIdentity&, Simulation<3>&,
                         const OutputState&);
template OutputState load_state(const std::string&, const CheckpointIdentity&, Simulation<2>&);
template OutputState load_state(const std::string&, const CheckpointIdentity&, Simulation<3>&);
template std::string state_hash(const Simulation<2>&);
template std::string state_hash(const Simulation<3>&);

}  // namespace breccia
