#include "studies/evolution/frame_file.h"

#include "studies/io/errors.h"
#include "studies/io/output.h"
#include "studies/mesh_files/mesh_file.h"
#include "studies/parameters/input_kind.h"
#include "studies/parameters/physics_numbers.h"

#include <fmt/format.h>

#include <array>
#include <string>

namespace sbeh::studies {

namespace {

Eigen::VectorXd number(double value) { return Eigen::VectorXd::Constant(1, value); }

// What a record tells of the step that led to the state, besides its energy.
Eigen::VectorXd of_step(const surface3d::FlowRecord& r) {
  return (Eigen::VectorXd(10) << r.time_step, r.dissipation.friction, r.dissipation.order,
          r.dissipation.viscous, r.energy_balance, r.normal_speed, r.order_speed, r.speed_max,
          r.lambda, r.ends ? int(*r.ends) : -1)
      .finished();
}
void set_step(surface3d::FlowRecord& r, const Eigen::VectorXd& step) {
  r.time_step = step[0];
  r.dissipation = {step[1], step[2], step[3]};
  r.energy_balance = step[4];
  r.normal_speed = step[5];
  r.order_speed = step[6];
  r.speed_max = step[7];
  r.lambda = step[8];
  if (step[9] >= 0) r.ends = surface3d::FlowStop(int(step[9]));
}

// Of a frame; throws when the file has it not, or not of this size.
template <class Map>
const auto& part(const Map& parts, const std::string& name, Eigen::Index size,
                 const std::filesystem::path& path) {
  const auto found = parts.find(name);
  if (found == parts.end() || found->second.size() != size)
    throw InputError(
        fmt::format("{}: is no frame of a run: it lacks the field {}", path.string(), name));
  return found->second;
}

// What the stepper remembers, among the fields and globals of a frame, and back.
void remember(const surface3d::StepperMemory& memory, NodeFields& at_nodes, Globals& globals) {
  if (memory.last.flow.size() == 0) return;
  at_nodes["factored_at"] = memory.factored_at.X;
  at_nodes["factored_order"] = memory.factored_at.beta.transpose();
  globals["factored"] = Eigen::Vector4d(memory.factored_tau, memory.solves, memory.iterations,
                                        memory.last_iterations);
  for (const auto& [name, solution] :
       {std::pair("solution", &memory.last), std::pair("solution_before", &memory.before)}) {
    if (solution->flow.size() == 0) continue;
    globals[std::string(name) + "_flow"] = solution->flow;
    globals[std::string(name) + "_motion"] = solution->motion;
    globals[std::string(name) + "_step"] = number(solution->tau);
  }
}

surface3d::Solution solution_of(const Globals& globals, const std::string& name) {
  const auto flow = globals.find(name + "_flow"), motion = globals.find(name + "_motion"),
             step = globals.find(name + "_step");
  if (flow == globals.end() || step == globals.end() || step->second.size() != 1) return {};
  return {.flow = flow->second,
          .motion = motion == globals.end() ? Eigen::VectorXd() : motion->second,
          .tau = step->second[0]};
}

surface3d::StepperMemory memory_of(const CurvedFile& file, const std::filesystem::path& path) {
  if (!file.globals.contains("factored")) return {};
  const Eigen::VectorXd& factored = part(file.globals, "factored", 4, path);
  const Eigen::Index nodes = file.mesh.node_count();
  return {.factored_at = {part(file.fields, "factored_at", 3 * nodes, path),
                          part(file.fields, "factored_order", nodes, path).transpose()},
          .factored_tau = factored[0],
          .solves = int(factored[1]),
          .iterations = int(factored[2]),
          .last_iterations = int(factored[3]),
          .last = solution_of(file.globals, "solution"),
          .before = solution_of(file.globals, "solution_before")};
}

// The steps before, the last one first, by their names in a frame.
constexpr std::array past_steps{"past", "earlier"};

void remember(const model::StepHistory<surface3d::State>& history, NodeFields& at_nodes,
              Globals& globals) {
  if (history.past.empty()) return;
  globals["formula_steps"] = number(history.steps);
  for (std::size_t k = 0; k < history.past.size(); ++k) {
    const auto& past = history.past[k];
    const std::string name = past_steps.at(k);
    at_nodes[name] = past.state.X;
    at_nodes[name + "_order"] = past.state.beta.transpose();
    const auto& [friction, order, viscous] = past.dissipation;
    globals[name + "_step"] = Eigen::Vector4d(past.tau, friction, order, viscous);
  }
}

// Frames of 0.1.0 have at most one step.
model::StepHistory<surface3d::State> history_of(const CurvedFile& file,
                                                const std::filesystem::path& path) {
  model::StepHistory<surface3d::State> history;
  const Eigen::Index nodes = file.mesh.node_count();
  for (const std::string name : past_steps) {
    if (!file.globals.contains(name + "_step")) break;
    const Eigen::VectorXd& step = part(file.globals, name + "_step", 4, path);
    history.past.push_back({.state = {part(file.fields, name, 3 * nodes, path),
                                      part(file.fields, name + "_order", nodes, path).transpose()},
                            .tau = step[0],
                            .dissipation = {step[1], step[2], step[3]}});
  }
  if (file.globals.contains("formula_steps"))
    history.steps = int(part(file.globals, "formula_steps", 1, path)[0]);
  return history;
}

CurvedFile read_curved(const std::filesystem::path& path) {
  auto curved = read_curved_mesh(path);
  if (!curved || curved->mesh.order != 3)
    throw InputError(
        fmt::format("{}: is no frame of a run: its triangles are not of order 3", path.string()));
  return std::move(*curved);
}

FlowMoment moment_of(const CurvedFile& file, const std::filesystem::path& path) {
  const meshing::CurvedMesh& mesh = file.mesh;
  FlowMoment frame{
      .mesh = std::make_shared<const surface3d::Triangulation>(mesh),
      .state = {mesh.nodes, part(file.fields, "order", mesh.node_count(), path).transpose()},
      .target = {}};
  if (const auto V = file.fields.find("velocity"); V != file.fields.end())
    frame.fields.V = V->second;
  frame.record.time = part(file.globals, "TimeValue", 1, path)[0];
  frame.record.next_step = part(file.globals, "next_step", 1, path)[0];
  frame.record.rejected = int(part(file.globals, "rejected_steps", 1, path)[0]);
  if (file.globals.contains("energy_rises")) {  // frames of 0.1.0 lack it
    const Eigen::VectorXd& rises = part(file.globals, "energy_rises", 3, path);
    frame.record.rises = {rises[0], rises[1], rises[2]};
  }
  set_step(frame.record, part(file.globals, "step", 10, path));
  const Eigen::VectorXd& target = part(file.globals, "target", 2, path);
  frame.target = {target[0], target[1]};
  frame.memory.remeshing_over = part(file.globals, "remeshing_over", 1, path)[0] != 0;
  frame.memory.stepper = memory_of(file, path);
  frame.memory.history = history_of(file, path);
  return frame;
}

// Of the run in whose folder the frame lies.
std::optional<Physics> physics_beside(const std::filesystem::path& frame) {
  const std::filesystem::path folder = std::filesystem::absolute(frame).parent_path();
  for (const auto& at : {folder.parent_path(), folder}) {
    const std::filesystem::path description = at / "run.toml";
    const bool own = at == folder || folder.filename() == "frames";
    if (own && std::filesystem::exists(description) && kind_of(description) == InputKind::run)
      return read_physics(description);
  }
  return {};
}

}  // namespace

meshing::CurvedMesh curved_mesh(const FlowMoment& moment) {
  return {.order = 3, .triangles = moment.mesh->triangles, .nodes = moment.state.X};
}

void write_frame(const std::filesystem::path& path, const FlowMoment& m, const Physics& physics) {
  const auto curvature = surface3d::curvature_of(*m.mesh, m.state.X);
  if (!curvature) throw std::runtime_error("the surface is degenerate");
  NodeFields at_nodes{{"order", m.state.beta.transpose()},
                      {"mean_curvature", curvature->H.transpose()},
                      {"normal", curvature->node_normals}};
  if (m.fields.V.size() > 0) at_nodes["velocity"] = m.fields.V;
  const surface3d::FlowRecord& r = m.record;
  Globals globals{{"TimeValue", number(r.time)},
                  {"next_step", number(r.next_step)},
                  {"rejected_steps", number(r.rejected)},
                  {"step", of_step(r)},
                  {"energy_rises", Eigen::Vector3d(r.rises.sum, r.rises.from, r.rises.to)},
                  {"target", Eigen::Vector2d(m.target.area, m.target.volume)},
                  {"remeshing_over", number(m.memory.remeshing_over)}};
  write_physics(physics, globals);
  remember(m.memory.stepper, at_nodes, globals);
  remember(m.memory.history, at_nodes, globals);
  write_file(path, vtu_text(curved_mesh(m), at_nodes, globals));
}

FlowMoment read_frame(const std::filesystem::path& path) {
  return moment_of(read_curved(path), path);
}

std::optional<Physics> physics_of_frame(const std::filesystem::path& path) {
  const CurvedFile file = read_curved(path);
  moment_of(file, path);  // or it is no frame
  const auto physics = physics_in(file.globals, path.string());
  return physics ? physics : physics_beside(path);
}

}  // namespace sbeh::studies
