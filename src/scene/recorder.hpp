#pragma once
#include "io/csv.hpp"
#include "io/frame_series.hpp"
#include "io/run_folder.hpp"
#include "scene/fragments.hpp"
#include "scene/simulation.hpp"
#include "scene/state_file.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace breccia {

/// Columns of the history of a simulation that has started.
template <int D>
std::vector<std::string> history_columns(Simulation<D>& simulation);

/// Seconds between two rows of the history.
double history_interval(const Settings& scene);

/// Everything a run writes while it runs: history, events, fragments, frames, checkpoints, in
/// simulated time. Keeps the history in memory for the checks.
template <int D>
class Recorder {
 public:
  /// `whole`: the whole scene with its state of now, put together by all ranks; null on those that
  /// write nothing. They have no folder.
  Recorder(Simulation<D>& simulation, const RunFolder* folder, const Settings& scene,
           std::function<Simulation<D>*()> whole);

  /// Another simulation goes on with the same state.
  void follow(Simulation<D>& simulation) { simulation_ = &simulation; }

  /// Starts empty files, or goes on where a checkpoint stood.
  void start();
  void resume(const OutputState& state);

  /// True when this step's state is to be seen.
  bool due() const { return history_due() || frame_due(); }
  void before();  ///< between the last force and the motion
  void after();
  /// From now on every state is seen: for the closing kick of the run.
  void expect_last() { final_ = true; }
  /// What can be told when no face breaks any more: emissions.csv.
  void finish();
  /// State of the files, all of it on the disk.
  OutputState sync();

  const std::vector<std::string>& columns() const { return row_.columns(); }
  const std::vector<std::vector<double>>& history() const { return history_; }
  const Ledger& last_ledger() const { return ledger_; }
  const std::vector<CrackFace>& last_cracks() const { return cracks_; }
  std::size_t last_fragments() const { return fragment_count_; }

 private:
  bool history_due() const;
  bool frame_due() const;
  void write_row();
  void write_frame();
  void draw(Simulation<D>& whole, Picture& picture);
  void write_fragments(const Fragments& fragments);
  void write_events();
  void read_history(std::int64_t rows);

  Simulation<D>* simulation_;
  const RunFolder* folder_;
  std::function<Simulation<D>*()> whole_;
  double duration_, interval_;
  double emission_reach_ = 0;  ///< m; 0: by the faces that broke
  std::int64_t frames_;
  std::int64_t next_history_ = 0, next_frame_ = 0;
  bool final_ = false;
  Row row_;
  Ledger ledger_;
  std::vector<std::vector<double>> history_;
  std::vector<CrackFace> cracks_;
  std::size_t fragment_count_ = 0;
  std::int64_t fragment_frame_ = 0;
  std::unique_ptr<HistoryWriter> history_file_;
  std::unique_ptr<EventWriter> event_file_;
  std::unique_ptr<FragmentWriter> fragment_file_;
  std::unique_ptr<FrameSeries> frame_series_;
  std::int64_t history_rows_ = 0;
  std::int64_t releases_seen_ = 0;
};

}  // namespace breccia
