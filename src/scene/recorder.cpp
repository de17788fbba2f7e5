#include "scene/recorder.hpp"

#include "modules/fracture/fracture.hpp"
#include "scene/emissions.hpp"
#include "scene/frame_builder.hpp"
#include "scene/part_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

namespace breccia {

namespace {

/// History rows of a run whose scene does not say how many.
constexpr double kDefaultRows = 1000;

/// Round-off of summed steps: an instant that is this near (in steps) counts as reached.
constexpr double kNear = 1e-6;

/// Breaks that are this many faces apart or nearer may be one emission.
constexpr double kReachInFaces = 3;

template <int D>
void observe_before(Simulation<D>& simulation, Row& row, Ledger& ledger) {
  row.set("time", simulation.clock().time);
  row.set("step", static_cast<double>(simulation.clock().step));
  row.set("dt", simulation.clock().dt);
  simulation.book_before(ledger);
  for (const auto& module : simulation.modules())
    module->observe(simulation.model(), simulation.clock(), Moment::before, row);
}

template <int D>
void observe_after(Simulation<D>& simulation, Row& row, Ledger& ledger) {
  simulation.book_after(ledger);
  row.set("KE", ledger.kinetic);
  for (const Ledger::Entry& entry : ledger.entries()) row.set(entry.name, entry.joule);
  row.set("W_ext", ledger.external());
  row.set("RES_1", ledger.residual_1());
  row.set("RES_2", ledger.residual_2());
  for (const auto& module : simulation.modules())
    module->observe(simulation.model(), simulation.clock(), Moment::after, row);
  if (const World* world = simulation.model().part.world) row.merge(*world);
}

/// The events of a step at the rank that writes them, by their places so that their order does not
/// depend on who saw them.
std::vector<Event> of_all_ranks(std::vector<Event> events, const World* world) {
  if (world == nullptr) return events;
  std::vector<char> bytes(events.size() * sizeof(Event));
  std::memcpy(bytes.data(), events.data(), bytes.size());
  events.clear();
  for (const std::vector<char>& part : world->collect(bytes)) {
    const std::size_t before = events.size();
    events.resize(before + part.size() / sizeof(Event));
    std::memcpy(events.data() + before, part.data(), part.size());
  }
  std::stable_sort(events.begin(), events.end(), [](const Event& a, const Event& b) {
    return std::lexicographical_compare(a.place, a.place + 3, b.place, b.place + 3);
  });
  return events;
}

}  // namespace

template <int D>
std::vector<std::string> history_columns(Simulation<D>& simulation) {
  Row row;
  Ledger ledger;
  observe_before(simulation, row, ledger);
  observe_after(simulation, row, ledger);
  return row.columns();
}

double history_interval(const Settings& scene) {
  const Settings& output = scene.at("output");
  return output.has("history") ? output.number("history")
                               : scene.at("run").number("duration") / kDefaultRows;
}

template <int D>
Recorder<D>::Recorder(Simulation<D>& simulation, const RunFolder* folder, const Settings& scene,
                      std::function<Simulation<D>*()> whole)
    : simulation_(&simulation),
      folder_(folder),
      whole_(std::move(whole)),
      duration_(scene.at("run").number("duration")) {
  const Settings& output = scene.at("output");
  interval_ = history_interval(scene);
  frames_ = output.integer("frames");
  if (output.has("emission_reach")) emission_reach_ = output.number("emission_reach");
}

template <int D>
void Recorder<D>::start() {
  if (folder_ == nullptr) return;
  if (Fracture<D>::wanted(simulation_->scene()))
    event_file_ = std::make_unique<EventWriter>(folder_->events(), D);
  if (frames_ > 0) {
    fragment_file_ = std::make_unique<FragmentWriter>(folder_->fragments(), D);
    frame_series_ = std::make_unique<FrameSeries>(folder_->path());
  }
}

template <int D>
void Recorder<D>::resume(const OutputState& state) {
  next_history_ = state.next_history;
  next_frame_ = state.next_frame;
  history_rows_ = state.history_rows;
  if (folder_ == nullptr) return;
  read_history(state.history_rows);
  if (Fracture<D>::wanted(simulation_->scene()))
    event_file_ = std::make_unique<EventWriter>(folder_->events(), D, state.event_rows);
  if (frames_ > 0) {
    fragment_file_ = std::make_unique<FragmentWriter>(folder_->fragments(), D, state.fragment_rows);
    frame_series_ = std::make_unique<FrameSeries>(folder_->path(), state.frame_times);
    fragment_frame_ = static_cast<std::int64_t>(state.frame_times.size());
  }
}

template <int D>
void Recorder<D>::read_history(std::int64_t rows) {
  std::ifstream file(folder_->history());
  std::string line, cell;
  if (!std::getline(file, line)) return;
  std::stringstream head(line);
  while (std::getline(head, cell, ',')) row_.set(cell, 0);
  for (std::int64_t r = 0; r < rows && std::getline(file, line); ++r) {
    std::vector<double> values;
    std::stringstream cells(line);
    while (std::getline(cells, cell, ',')) values.push_back(std::stod(cell));
    history_.push_back(std::move(values));
  }
  if (rows > 0)
    history_file_ = std::make_unique<HistoryWriter>(folder_->history(), row_.columns(), rows);
}

template <int D>
bool Recorder<D>::history_due() const {
  const Clock& clock = simulation_->clock();
  return final_ || clock.time >= static_cast<double>(next_history_) * interval_ - kNear * clock.dt;
}

template <int D>
bool Recorder<D>::frame_due() const {
  if (frames_ == 0) return false;
  const Clock& clock = simulation_->clock();
  const double next = duration_ * static_cast<double>(next_frame_) / static_cast<double>(frames_);
  return final_ || clock.time >= next - kNear * clock.dt;
}

template <int D>
void Recorder<D>::before() {
  if (!due()) return;
  row_.restart_row();
  ledger_ = Ledger{};
  observe_before(*simulation_, row_, ledger_);
  if (!frame_due() && !final_) return;
  write_frame();
  ++next_frame_;
}

template <int D>
void Recorder<D>::after() {
  write_events();
  if (!history_due()) return;
  write_row();
  while (!final_ && static_cast<double>(next_history_) * interval_ <=
                        simulation_->clock().time + kNear * simulation_->clock().dt)
    ++next_history_;
}

template <int D>
void Recorder<D>::write_row() {
  observe_after(*simulation_, row_, ledger_);
  ++history_rows_;
  if (folder_ == nullptr) return;
  if (!history_file_)
    history_file_ = std::make_unique<HistoryWriter>(folder_->history(), row_.columns());
  history_file_->write(row_.values());
  history_.push_back(row_.values());
}

template <int D>
void Recorder<D>::write_frame() {
  Picture picture;
  Simulation<D>* whole = whole_();
  if (whole != simulation_) draw_parts(*simulation_, whole, picture);
  if (whole != nullptr) draw(*whole, picture);
}

template <int D>
void Recorder<D>::draw(Simulation<D>& whole, Picture& picture) {
  const Fragments fragments = find_fragments(whole.model());
  for (const auto& module : whole.modules())
    if (&whole == simulation_ || !module->draws_forces()) module->draw(whole.model(), picture);
  if (frames_ > 0) {
    const FrameBuilder<D> frame(whole.model(), simulation_->clock(), picture, fragments);
    frame.write(*frame_series_);
    write_fragments(fragments);
  }
  fragment_count_ = fragments.pieces.size();
  cracks_ = std::move(picture.cracks);
}

template <int D>
void Recorder<D>::write_fragments(const Fragments& fragments) {
  std::vector<FragmentRow> rows;
  for (std::size_t i = 0; i < fragments.pieces.size(); ++i) {
    const Fragments::Piece& piece = fragments.pieces[i];
    FragmentRow row;
    row.fragment = static_cast<std::int64_t>(i);
    row.elements = piece.elements;
    row.mass = piece.mass;
    row.size =
        D == 2 ? std::sqrt(piece.volume / simulation_->model().thickness) : std::cbrt(piece.volume);
    std::copy_n(piece.place, 3, row.place.begin());
    std::copy_n(piece.velocity, 3, row.velocity.begin());
    std::copy_n(piece.spin, 3, row.spin.begin());
    row.length = piece.length;
    row.width = piece.width;
    rows.push_back(row);
  }
  fragment_file_->write(simulation_->clock().time, fragment_frame_++, rows);
}

template <int D>
void Recorder<D>::write_events() {
  const Model<D>& model = simulation_->model();
  if (!model.part.whole() && model.releases == releases_seen_) return;
  releases_seen_ = model.releases;
  std::vector<Event> events;
  for (const auto& module : simulation_->modules()) {
    const std::vector<Event> more = module->take_events();
    events.insert(events.end(), more.begin(), more.end());
  }
  events = of_all_ranks(std::move(events), model.part.world);
  if (!event_file_ || events.empty()) return;
  std::vector<CrackEvent> rows;
  for (const Event& event : events) {
    CrackEvent row;
    row.time = event.time;
    std::copy_n(event.place, 3, row.place.begin());
    std::copy_n(event.normal, 3, row.normal.begin());
    row.area = event.area;
    row.mode = event.mode;
    row.energy_tension = event.energy_tension;
    row.energy_shear = event.energy_shear;
    row.opening = event.opening;
    row.slip = event.slip;
    row.moment = event.moment;
    rows.push_back(row);
  }
  event_file_->write(rows);
}

/// Reaches three faces unless the scene says otherwise; cracks run at half the speed of the slowest
/// shear waves.
template <int D>
void Recorder<D>::finish() {
  if (!event_file_) return;
  const std::vector<CrackEvent> events = read_events(folder_->events(), D, event_file_->rows());
  const Model<D>& model = simulation_->model();
  double area = 0, shear_wave = 1e300;
  for (const CrackEvent& event : events) area += event.area;
  for (const Material& m : model.materials)
    shear_wave = std::min(shear_wave, std::sqrt(m.mu() / m.density));
  const double mean = events.empty() ? 1 : area / static_cast<double>(events.size());
  const double face = D == 2 ? mean / model.thickness : std::sqrt(2 * mean);
  const double reach = emission_reach_ > 0 ? emission_reach_ : kReachInFaces * face;
  write_emissions(folder_->emissions(), D, find_emissions(events, {reach, 2 * reach / shear_wave}));
}

template <int D>
OutputState Recorder<D>::sync() {
  OutputState state;
  if (history_file_) history_file_->sync();
  state.history_rows = history_rows_;
  if (event_file_) {
    event_file_->sync();
    state.event_rows = event_file_->rows();
  }
  if (fragment_file_) {
    fragment_file_->sync();
    state.fragment_rows = fragment_file_->rows();
  }
  if (frame_series_) state.frame_times = frame_series_->times();
  state.next_history = next_history_;
  state.next_frame = next_frame_;
  return state;
}

template std::vector<std::string> history_columns<2>(Simulation<2>&);
template std::vector<std::string> history_columns<3>(Simulation<3>&);
template class Recorder<2>;
template class Recorder<3>;

}  // namespace breccia
