#include "studies/rest_states/pass_crossing.h"

#include "studies/evolution/frame_file.h"
#include "studies/io/interrupt.h"
#include "studies/io/progress.h"
#include "studies/rest_states/descent.h"
#include "surface3d/stationary/deflation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sbeh::studies {

namespace fs = std::filesystem;
using surface3d::Eigenmode;

namespace {

constexpr double largest_amplitude = 0.05, smallest_amplitude = 1e-3;  // radii, or of order

bool is_pass(const RestRow& row) {
  return row.status == PointStatus::stationary && row.measures->negative_directions == 1
      && (row.point == RestPoint::first || row.point == RestPoint::step
          || row.point == RestPoint::last);
}

StatesInput input_at(const StatesInput& input, const RestRow& row) {
  StatesInput here = input;
  if (follows_other_number(input)) here = at_value(here, input.follow->parameter, row.followed);
  here.reduced_volume = {row.reduced_volume};
  here.L = {row.L};
  return here;
}

// A pass and what surrounds it.
class Crossing {
 public:
  Crossing(const StatesInput& input, const OutputFolder& folder, RestTable& states,
           const RestRow& pass, ProgressLine& line, std::string words)
      : input_(input_at(input, pass)),
        folder_(folder),
        states_(states),
        pass_(pass),
        at_{pass.reduced_volume, pass.L},
        membrane_{input_.material.with_L1(at_.L), input_.model,
                  axisym::target_of(at_.reduced_volume)},
        line_(line),
        words_(std::move(words)) {}

  /// Why it cannot be begun; empty where it can.
  std::string begin() {
    const FlowMoment frame = read_frame(frame_of(folder_.path(), pass_.key));
    from_ = rest_state_from(input_, at_, {frame.mesh, frame.state, {}, {}});
    if (!from_.failure.empty()) return from_.failure;
    const auto modes = surface3d::lowest_modes(*from_.system, from_.state, from_.normals, 1);
    if (!modes || modes->empty()) return "its mode is not found";
    mode_ = modes->front();
    amplitude_ = amplitude();
    return {};
  }

  PassEnd go_down(double side) {
    constexpr int most_tries = 3;
    PassEnd end;
    std::shared_ptr<const surface3d::Triangulation> mesh = from_.mesh;
    surface3d::State from = start(side * amplitude_);
    for (int tries = 1;; ++tries) {
      const Descent flow = descend(membrane_, mesh, from,
                                   [this](const surface3d::FlowRecord& record) { show(record); });
      end.energy = flow.energy;
      end.time = (tries == 1 ? 0 : end.time) + flow.time;
      end.stop_reason = flow.reason;
      if (!flow.rests || interrupt_signal()) return end;
      const RestState there = state_near(flow);
      if (there.failure.empty()) {
        if (there.system->negative_directions() == 0 || tries == most_tries)
          return take(there, end), end;
        mesh = there.mesh;
        from = beyond(there, side);
        continue;
      }
      end.stop_reason = there.failure;
      // The way on to the state was too far for these triangles.
      const RestStart on =
          remeshed_start(*flow.mesh, flow.state, membrane_.material, flow.mesh->count() * 3 / 2);
      if (!on.mesh || tries == most_tries) return end;
      mesh = on.mesh;
      from = on.state;
    }
  }

  /// Whether a symmetry of the pass turns the one way into the other: what marks a state changes as the square of the amplitude then.
  bool ways_are_alike() const {
    constexpr double share = 0.3;
    const auto marks = [&](double by) { return marks_of(*from_.mesh, guess(start(by))); };
    const surface3d::StateMarks one = marks(amplitude_), other = marks(-amplitude_),
                                here = marks(0);
    return (one - other).norm() < share * (one + other - 2 * here).norm();
  }

 private:
  // From where a flow nearly rests Newton's method goes not far, but slowly next to a branching point.
  static inline const surface3d::NewtonOptions far{.most_iterations = 40, .far = 10};

  // Resolved, or a failure. On new triangles where there are any: a flow has drawn its own along.
  RestState state_near(const Descent& flow) const {
    RestState there = rest_state_from(input_, at_, {flow.mesh, flow.state, {}, {}}, far);
    if (!there.failure.empty()) return there;
    RestState anew = on_new_triangles(input_, at_, there);
    return anew.failure.empty() || !resolved_by(*there.mesh, there.state.X) ? anew : there;
  }

  surface3d::State start(double by) const {
    return displaced(membrane_, {*from_.mesh, from_.state, from_.normals}, mode_, by);
  }
  // From another saddle, or the same on other triangles, where a flow was slow: the way that is nearer to its beginning.
  surface3d::State beyond(const RestState& saddle, double side) const {
    const auto modes = surface3d::lowest_modes(*saddle.system, saddle.state, saddle.normals, 1);
    if (!modes || modes->empty()) return saddle.state;
    const surface3d::StateMarks begun = marks_of(*from_.mesh, guess(start(side * amplitude_)));
    const auto way = [&](double by) {
      return displaced(membrane_, {*saddle.mesh, saddle.state, saddle.normals}, modes->front(), by);
    };
    const auto distance = [&](double by) {
      const surface3d::StationaryState there =
          surface3d::guess_from(*saddle.mesh, membrane_.material, membrane_.model, way(by));
      return (marks_of(*saddle.mesh, there) - begun).norm();
    };
    return way(distance(amplitude_) < distance(-amplitude_) ? amplitude_ : -amplitude_);
  }
  surface3d::StationaryState guess(const surface3d::State& shape) const {
    return surface3d::guess_from(*from_.mesh, membrane_.material, membrane_.model, shape);
  }

  // The energy still falls along some direction there: next to a branching point both ends of a short pass are near.
  double amplitude() const {
    double by = largest_amplitude;
    const auto is_on_the_pass = [&](double side) {
      const surface3d::State there = start(side * by);
      return surface3d::curvature_of(*from_.mesh, there.X)
          && from_.system->linearise(guess(there), surface3d::node_normals(*from_.mesh, there.X))
          && from_.system->negative_directions() > 0;
    };
    while (by > smallest_amplitude && !(is_on_the_pass(1) && is_on_the_pass(-1))) by /= 2;
    return by;
  }

  void take(const RestState& there, PassEnd& end) {
    const int negative = there.system->negative_directions();
    const std::optional<int> number = number_of(there, negative);
    if (!number) return;
    const RestRow& row = *states_.find(*number);
    end.state = number;
    end.symmetry = row.measures->symmetry;
    end.negative_directions = row.measures->negative_directions;
    end.energy = energy_of(row);
    end.barrier = energy_of(pass_) - end.energy;
    end.stop_reason = row.status != PointStatus::stationary ? row.stop_reason
                    : negative > 0                          ? "it stays at a saddle"
                                                            : at_rest;
  }

  // Of the same state where the table has it, else of its new row; none after an interrupt.
  std::optional<int> number_of(const RestState& there, int negative) {
    const surface3d::StateMarks marks = marks_of(*there.mesh, there.state);
    for (const auto& [number, row] : states_.rows())
      if (is_here(row) && row.measures->negative_directions == negative
          && surface3d::is_known({marks_of_row(number)}, marks))
        return number;
    const int number = states_.rows().rbegin()->first + 1;
    RestRow row = row_at(input_, {number, at_});
    row.path.reset();
    row.point = RestPoint::end;
    row.from = pass_.key;
    row.followed = pass_.followed;
    const SeenState seen{*there.system, there.mesh, there.state, there.normals, at_};
    measure(input_, seen, folder_.path(), row);
    row.energy_error = energy_error_on_path(input_, row, seen);
    if (interrupt_signal()) return {};
    states_.append(row);
    return number;
  }
  bool is_here(const RestRow& row) const {
    return row.measures && row.reduced_volume == pass_.reduced_volume && row.L == pass_.L
        && (!follows_other_number(input_) || row.followed == pass_.followed);
  }
  surface3d::StateMarks marks_of_row(int number) const {
    const FlowMoment frame = read_frame(frame_of(folder_.path(), number));
    return marks_of(*frame.mesh, surface3d::guess_from(*frame.mesh, membrane_.material,
                                                       membrane_.model, frame.state));
  }

  void show(const surface3d::FlowRecord& record) {
    constexpr double terminal_pace = 0.2, log_pace = 30;  // seconds
    if (line_.age() > (line_.on_terminal() ? terminal_pace : log_pace))
      line_.show(
          fmt::format("{}: t = {:.4g}, energy {:.8g}", words_, record.time, record.energy.total()));
  }

  StatesInput input_;
  const OutputFolder& folder_;
  RestTable& states_;
  const RestRow& pass_;
  axisym::PlanePoint at_;
  Membrane membrane_;
  ProgressLine& line_;
  std::string words_;
  RestState from_{};
  Eigenmode mode_{};
  double amplitude_ = 0;
};

PassRow begun(const RestRow& pass) {
  PassRow row;
  row.key = pass.key;
  row.reduced_volume = pass.reduced_volume;
  row.L = pass.L;
  row.followed = pass.followed;
  row.symmetry = pass.measures->symmetry;
  row.energy = energy_of(pass);
  return row;
}

void conclude(const Crossing& crossing, PassRow& row) {
  const auto& [one, other] = row.ends;
  const bool rest = one.stop_reason == at_rest && other.stop_reason == at_rest;
  row.kind = !rest                    ? PassKind::no_rest
           : one.state == other.state ? PassKind::one_state
                                      : PassKind::two_states;
  if (row.kind == PassKind::one_state)
    row.remark = crossing.ways_are_alike()
                   ? "a symmetry of the pass turns the one way into the other"
                   : "both ways lead to the same state";
}

}  // namespace

bool passes_begun(const OutputFolder& folder) { return fs::exists(folder / "passes.csv"); }

std::vector<PassRow> cross_passes(const StatesInput& input, const OutputFolder& folder,
                                  RestTable& states) {
  const Columns<PassRow> columns = pass_columns(input);
  GrowingTable<PassRow> table(folder / "passes.csv", columns, "passes",
                              "that pass gone down again");
  std::vector<RestRow> passes;
  for (const auto& [number, row] : states.rows())
    if (is_pass(row)) passes.push_back(row);
  ProgressLine line;
  for (std::size_t k = 0; k < passes.size() && !interrupt_signal(); ++k) {
    const PassRow* there = table.find(passes[k].key);
    if (there && there->kind != PassKind::open) continue;
    PassRow row = there ? *there : begun(passes[k]);
    const std::string words = fmt::format("pass {} of {}: state {}", k + 1, passes.size(), row.key);
    line.show(words);
    Crossing crossing(input, folder, states, passes[k], line, words);
    const std::string failure = crossing.begin();
    for (const std::size_t side : {0u, 1u}) {
      PassEnd& end = row.ends[side];
      if (end.is_gone()) continue;
      if (failure.empty())
        end = crossing.go_down(side == 0 ? 1 : -1);
      else
        end.stop_reason = failure;
      if (interrupt_signal()) break;
      if (side == 1) conclude(crossing, row);
      table.append(row);
    }
  }
  line.end();
  table.sort();
  std::vector<PassRow> rows;
  for (const auto& [key, row] : table.rows()) rows.push_back(row);
  return rows;
}

}  // namespace sbeh::studies
