#include "surface3d/shared_flow.h"

#include <fmt/format.h>

#include <bit>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace sbeh::surface3d {

namespace {

struct Task {
  model::Material material;
  model::Model model{};
  FlowMoment start{};
  Numerics numerics;
  FlowSchedule schedule;
};

template <class T>
concept Bytes = std::is_trivially_copyable_v<T>;
template <class T>
concept Matrix = std::is_base_of_v<Eigen::PlainObjectBase<T>, T>;

// Raw numbers, one after the other.
class Writer {
 public:
  const std::string& text() const { return text_; }

  template <Bytes T>
  void operator()(const T& value) {
    text_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <Matrix M>
  void operator()(const M& x) {
    (*this)(x.rows());
    (*this)(x.cols());
    append(x.data(), std::size_t(x.size()));
  }
  void operator()(const std::vector<double>& numbers) {
    (*this)(numbers.size());
    append(numbers.data(), numbers.size());
  }
  void operator()(const model::Polynomial& p) { (*this)(p.coefficients()); }
  void operator()(const meshing::PointGroup& group) {
    (*this)(group.symbol().size());
    text_ += group.symbol();
  }

 private:
  template <class Number>
  void append(const Number* numbers, std::size_t count) {
    text_.append(reinterpret_cast<const char*>(numbers), count * sizeof(Number));
  }
  std::string text_;
};

class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}

  template <Bytes T>
  void operator()(T& value) {
    copy(&value, 1);
  }
  template <Matrix M>
  void operator()(M& x) {
    Eigen::Index rows = 0, columns = 0;
    (*this)(rows);
    (*this)(columns);
    x.resize(rows, columns);
    copy(x.data(), std::size_t(x.size()));
  }
  void operator()(std::vector<double>& numbers) {
    std::size_t size = 0;
    (*this)(size);
    numbers.resize(size);
    copy(numbers.data(), size);
  }
  template <std::derived_from<model::Polynomial> P>
  void operator()(P& p) {
    std::vector<double> coefficients;
    (*this)(coefficients);
    p = P(coefficients);
  }
  void operator()(meshing::PointGroup& group) {
    std::size_t size = 0;
    (*this)(size);
    group = meshing::PointGroup(text_.substr(std::exchange(at_, at_ + size), size));
  }

 private:
  template <class Number>
  void copy(Number* numbers, std::size_t count) {
    const std::size_t size = count * sizeof(Number);
    if (at_ + size > text_.size()) throw std::logic_error("a flow among ranks: too few numbers");
    std::memcpy(static_cast<void*>(numbers), text_.data() + at_, size);
    at_ += size;
  }
  const std::string& text_;
  std::size_t at_ = 0;
};

void pass(auto& visit, model::maybe_const<State> auto& state) {
  visit(state.X);
  visit(state.beta);
}
void pass(auto& visit, model::maybe_const<Solution> auto& solution) {
  visit(solution.flow);
  visit(solution.motion);
  visit(solution.tau);
}
void pass(auto& visit, model::maybe_const<FlowMemory> auto& memory) {
  auto& stepper = memory.stepper;
  pass(visit, stepper.factored_at);
  visit(stepper.factored_tau);
  visit(stepper.solves);
  visit(stepper.iterations);
  visit(stepper.last_iterations);
  pass(visit, stepper.last);
  pass(visit, stepper.before);
  visit(memory.remeshing_over);
  auto& history = memory.history;
  visit(history.steps);
  std::size_t count = history.past.size();
  visit(count);
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(memory)>>)
    history.past.resize(count);
  for (auto& past : history.past) {
    pass(visit, past.state);
    visit(past.tau);
    visit(past.dissipation);
  }
}
// All but the triangles.
void pass(auto& visit, model::maybe_const<Task> auto& task) {
  const auto parameter = [&](const model::Parameter&, auto& value) { visit(value); };
  for_each_parameter(task.material, parameter);
  visit(task.model);
  for_each_parameter(task.numerics, parameter);
  visit(task.schedule.end_time);
  visit(task.schedule.output_times);
  visit(task.schedule.stop_at_rest);
  auto& start = task.start;
  pass(visit, start.state);
  visit(start.target);
  visit(start.record);
  pass(visit, start.memory);
  visit(start.symmetry.mesh);
  visit(start.symmetry.kept);
}

std::string written(const Task& task) {
  Writer writer;
  writer(task.start.mesh->triangles);
  pass(writer, task);
  return writer.text();
}

Task read(const std::string& text) {
  Task task;
  Reader reader(text);
  decltype(Triangulation::triangles) triangles;
  reader(triangles);
  pass(reader, task);
  task.start.mesh = std::make_shared<const Triangulation>(
      meshing::CurvedMesh{.order = 3, .triangles = triangles, .nodes = task.start.state.X});
  return task;
}

// Numbers that differ, as those of different processors do, would part the ranks sooner or later.
void require_same(const Ranks& ranks, const FlowRecord& record) {
  const double energy = record.energy.total();
  double of_first = energy;
  ranks.broadcast(std::as_writable_bytes(std::span(&of_first, 1)));
  if (std::bit_cast<std::uint64_t>(energy) == std::bit_cast<std::uint64_t>(of_first)) return;
  fmt::print(
      stderr,
      "sbeh: rank {} has come to another energy than the first one, at t = {}: do they run on "
      "different processors? They must be of one kind\n",
      ranks.rank(), record.time);
  abandon(ranks, 1);
}

[[noreturn]] void fail(const Ranks& ranks, const std::exception& error) {
  fmt::print(stderr, "sbeh: rank {}: {}\n", ranks.rank(), error.what());
  abandon(ranks, 1);
}

FlowResult run(const Task& task, const Ranks& ranks, const FlowObserver& observe) {
  return run_flow(task.material, task.model, task.start, task.numerics, task.schedule, observe,
                  ranks);
}

constexpr const char* no_more = "no more";

}  // namespace

FlowResult run_shared_flow(const model::Material& material, model::Model model,
                           const FlowMoment& start, const Numerics& numerics,
                           const FlowSchedule& schedule, const FlowObserver& observe,
                           const Ranks& ranks) {
  if (ranks.is_alone()) return run_flow(material, model, start, numerics, schedule, observe);
  if (ranks.count() > start.mesh->count())
    throw std::invalid_argument(fmt::format("{} triangles cannot be parted among {} ranks",
                                            start.mesh->count(), ranks.count()));
  const Task task{material, model, start, numerics, schedule};
  send_to_others(ranks, written(task));
  bool known_to_all = false;  // of an error
  const auto lead = [&](const FlowRecord& record, const State& state, const StepView& view,
                        bool exact) {
    require_same(ranks, record);
    try {
      return ranks.broadcast(observe(record, state, view, exact));
    } catch (...) {
      ranks.broadcast(false);
      known_to_all = true;
      throw;
    }
  };
  try {
    return run(task, ranks, lead);
  } catch (const std::invalid_argument&) {  // all have it
    throw;
  } catch (const std::exception& error) {
    if (known_to_all) throw;
    fail(ranks, error);
  }
}

void serve_first(const Ranks& ranks) {
  const auto follow = [&](const FlowRecord& record, const State&, const StepView&, bool) {
    require_same(ranks, record);
    return ranks.broadcast(false);
  };
  for (std::string text = await_first(ranks); text != no_more; text = await_first(ranks)) {
    try {
      if (SharedFactors::is_meant(text))
        SharedFactors::serve(text);
      else
        run(read(text), ranks, follow);
    } catch (const std::invalid_argument&) {  // the first one has it, too, and says it
    } catch (const std::exception& error) {
      fail(ranks, error);
    }
  }
}

void dismiss(const Ranks& ranks) { send_to_others(ranks, no_more); }

}  // namespace sbeh::surface3d
