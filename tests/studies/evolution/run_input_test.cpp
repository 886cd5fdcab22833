// Inputs of 3D runs: what is read, and what is refused with which words.
#include "studies/evolution/run_input.h"

#include "meshing/measures.h"
#include "meshing/shapes.h"
#include "studies/evolution/frame_file.h"
#include "studies/io/output.h"
#include "tests/studies/parameters/input_file.h"

#include <fmt/format.h>

namespace sbeh::studies {
namespace {

using namespace test;
namespace fs = std::filesystem;
using model::Model;

const std::string small_run =
    "model = \"SBEH\"\ntime.end = 10\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.8\n";

RunInput run_of(const std::string& text) { return read_run(written(text)); }

// Nothing in it is a default.
const Physics odd_physics{.model = Model::SBEH,
                          .material = {.L1 = 0.08,
                                       .L2 = -0.01,
                                       .L3 = 0.02,
                                       .potential = model::Potential({0.5, 0, -1, 0, 1}),
                                       .viscosity = 0.25,
                                       .immobility = 3,
                                       .friction_tangential = 0.5,
                                       .friction_normal = 0.75,
                                       .order_viscosity = -3,
                                       .residual_stiffness = 0.01,
                                       .spontaneous_curvature = -2.7}};

// A frame of a sphere that was computed with that.
fs::path written_frame(const Physics& physics) {
  const meshing::CurvedMesh sphere = meshing::sphere({.triangles = 20});
  fs::path file = path_of("frame.vtu");
  write_frame(
      file,
      {.mesh = std::make_shared<const surface3d::Triangulation>(sphere),
       .state = {sphere.nodes, surface3d::Field::Constant(sphere.node_count(), model::full_order)},
       .target = {meshing::area(sphere), meshing::volume(sphere)}},
      physics);
  return file;
}

// Renames what tells model and material, so that the frame is as version 0.1.0 wrote them.
fs::path forget_physics(const fs::path& frame) {
  std::string text = read_file(frame);
  for (const std::string name : {"\"model\"", "\"material."})
    for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos; ++at)
      text[at + 1] = 'x';
  write_file(frame, text);
  return frame;
}

TEST(RunInput, has_the_documented_defaults) {
  const RunInput input = run_of(small_run);
  EXPECT_EQ(input.model, Model::SBEH);
  const auto& ellipsoid = std::get<Ellipsoid>(input.start);
  EXPECT_EQ(ellipsoid.reduced_volume, 0.8);
  EXPECT_TRUE(ellipsoid.axes.empty());
  EXPECT_FALSE(ellipsoid.prolate);
  EXPECT_EQ(input.triangles, 320);
  EXPECT_EQ(input.initial_order, model::full_order);
  EXPECT_TRUE(input.perturbation.empty());
  EXPECT_EQ(input.times.end, 10);
  EXPECT_EQ(input.times.rows, default_row_times(10));
  EXPECT_EQ(input.times.states, default_state_times(10));
  EXPECT_FALSE(input.times.every_step);
  EXPECT_TRUE(input.times.stop_at_rest);
  EXPECT_EQ(input.checkpoint_minutes, 10);
  EXPECT_EQ(input.material, model::Material{});
  EXPECT_EQ(input.numerics, surface3d::Numerics{});
}

TEST(RunInput, reads_back_from_its_description_as_the_same_run) {
  const std::string sbeh = "model = 'SBEH'\n", ssh = "model = 'SSH'\n",
                    time = "[time]\nend = 0.3\n", frame = written_frame(odd_physics).string();
  const std::vector<std::string> texts{
      small_run,
      ssh + "[surface]\nshape = 'ellipsoid'\nreduced_volume = 0.65\nkind = 'prolate'\ntriangles = 1280\n"
          + time + "checkpoint_minutes = 0.25\nstop_at_rest = false\nframes = 0.3\noutput = [0.1, 0.2]\n",
      sbeh + "[surface]\nshape = 'ellipsoid'\naxes = [1, 0.5, 0.30000000000000004]\norder = 0.1\n"
          + "perturbation = [[2, 2, 1e-3], [3, -1, -0.1]]\n" + time,
      "model = 'SSH'\n[surface]\nshape = 'harmonics'\nmodes = [[2, 1, 5]]\nreduced_volume = 0.9\n"
          + time,
      "model = 'Helfrich-global'\n[surface]\nshape = 'harmonics'\nmodes = [[5, 3, 0.5]]\n" + time
          + "[numerics]\nscheme = 'monolithic'\nfactorisation = 'every-step'\ntolerance = 1e-3\n",
      sbeh + "[surface]\nshape = 'ellipsoid'\nreduced_volume = 0.9\ndomains = [{ fraction = 0.3, order "
          + "= 0.6 }, { axis = [0, 1, 0.5], fraction = 0.1, order = 0.55 }]\ndomain_width = 0.2\n"
          + "order_modes = [[2, 1, 0.01]]\norder_noise = { amplitude = 0.02, seed = 7 }\n" + time
          + "[material]\nL = 0.02\nkappa = [0.1, 0.2]\norder = 'diffusive'\nmean_order = 0.3\n"
          + "order_mobility = 0.5\n",
      sbeh + "[surface]\nshape = 'harmonics'\nmodes = [[5, 3, 0.5]]\nsymmetry = 'D3h'\n" + time,
      sbeh + "[surface]\nshape = 'harmonics'\nmodes = [[5, 3, 0.5]]\nperturbation = [[4, 3, 1e-3]]\n"
          + "symmetry = 'D3h'\nkeep_symmetry = 'C3v'\n" + time,
      sbeh + "[surface]\nshape = 'mesh'\nfile = '\"a\\b\" \xc3\xa4.obj'\norder = 0.25\n" + time,
      sbeh + "[surface]\nshape = 'frame'\nfile = '" + frame + "'\n" + time
          + "[material]\nL1 = 0.1\nL2 = -0.05\nL3 = 0.07\nresidual_stiffness = 0.01\n",
      "[surface]\nshape = 'frame'\nfile = '" + frame + "'\n" + time,
      ssh + "[surface]\nshape = 'scan'\nfolder = '" + scan_folder("") + "'\nreduced_volume = 0.7\n"
          + "L = 0.03\ntriangles = 5120\n" + time + "every_step = true\n",
  };
  for (const std::string& text : texts) {
    const RunInput input = run_of(text);
    const std::string description = describe(input, "1.2.3");
    EXPECT_EQ(input, run_of(description));
    EXPECT_EQ(describe(run_of(description), "1.2.3"), description);
  }
}

TEST(RunInput, from_a_scan_has_the_material_of_the_scan_with_the_rows_L) {
  const std::string start =
      "model = \"SSH\"\ntime.end = 1\n[surface]\nshape = \"scan\"\nfolder = \""
      + scan_folder("[material]\nspontaneous_curvature = -2.7\n")
      + "\"\nreduced_volume = 0.7\nL = 0.03\n";
  EXPECT_EQ(run_of(start).material.L1, 0.03);
  EXPECT_EQ(run_of(start).material.spontaneous_curvature, -2.7);
  EXPECT_EQ(run_of(start + "[material]\nL = 0.04").material.L1, 0.04);
  EXPECT_EQ(run_of(start + "[material]\nL = 0.04").material.spontaneous_curvature, -2.7);
}

TEST(RunInput, from_a_frame_has_its_model_and_material_but_for_what_is_said) {
  const std::string start = "time.end = 1\n[surface]\nshape = \"frame\"\nfile = \""
                          + written_frame(odd_physics).string() + "\"\n";
  const RunInput same = run_of(start);
  EXPECT_EQ(static_cast<const Physics&>(same), odd_physics);
  Physics changed = odd_physics;
  changed.model = Model::SSH;
  changed.material.spontaneous_curvature = 0;
  const RunInput input =
      run_of("model = \"SSH\"\n" + start + "[material]\nspontaneous_curvature = 0\n");
  EXPECT_EQ(static_cast<const Physics&>(input), changed);
}

TEST(RunInput, from_a_frame_of_unknown_material_needs_model_and_elastic_constants) {
  const fs::path folder = path_of("lonely");  // no run.toml beside it
  fs::create_directories(folder);
  fs::copy_file(written_frame({}), folder / "old.vtu", fs::copy_options::overwrite_existing);
  const std::string file = forget_physics(folder / "old.vtu").string();
  const std::string start = "time.end = 1\n[surface]\nshape = \"frame\"\nfile = \"" + file + "\"\n";
  const std::string unknown = "missing; " + file + " does not say with which ";
  expect_messages(
      read_run, "",
      {{start, ": model: " + unknown + "model it was computed"},
       {"model = 'SSH'\n" + start,
        ": [material] L: " + unknown
            + "material it was computed: give L, and all else that is not "
              "the default"},
       {"model = 'SSH'\n" + start + "[material]\nviscosity = 2\n",
        ":6: [material] L: " + unknown
            + "material it was computed: give L, and all else that is not the default"}});
  const RunInput input = run_of("model = \"SSH\"\n" + start + "[material]\nL = 0.08\n");
  EXPECT_EQ(input.material, model::Material{}.with_L(0.08));
  // Its run may still stand beside it.
  RunInput run;
  static_cast<Physics&>(run) = odd_physics;
  std::ofstream(folder / "run.toml") << describe(run, "0.1.0");
  EXPECT_EQ(static_cast<const Physics&>(run_of(start)), odd_physics);
}

TEST(RunInput, with_a_wrong_surface_is_refused_with_line_key_and_value) {
  const std::string modes =
      "must be a list of [l, m, amplitude], the degree l an integer in 0 ... 32, the order m in -l "
      "... l";
  const std::vector<Case> cases{
      {"",
       ":3: [surface] shape: missing; must be one of 'ellipsoid', 'harmonics', 'mesh', 'scan', "
       "'frame', 'mode'"},
      {"shape = 3",
       ":4: [surface] shape = 3: must be one of 'ellipsoid', 'harmonics', 'mesh', "
       "'scan', 'frame', 'mode'"},
      {"shap = 'mesh'", ":4: [surface] shap: unknown key; did you mean 'shape'?"},
  };
  expect_messages(read_run, "model = \"SBEH\"\ntime.end = 1\n[surface]\n", cases);
  const std::vector<Case> ellipsoids{
      {"", ":3: [surface] reduced_volume: missing; must be a number"},
      {"reduced_volume = 'a'", ":5: [surface] reduced_volume = 'a': must be a number"},
      {"reduced_volume = 0", ":5: [surface] reduced_volume = 0: must be > 0 and <= 1"},
      {"reduced_volume = 1.2", ":5: [surface] reduced_volume = 1.2: must be > 0 and <= 1"},
      {"reduced_volum = 0.8",
       ":5: [surface] reduced_volum: unknown key; did you mean 'reduced_volume'?"},
      {"axes = 1", ":5: [surface] axes = 1: must be a list of numbers"},
      {"axes = [1, 2]",
       ":5: [surface] axes = [1, 2]: must be three numbers, the semi-axes along x, y, z"},
      {"axes = [1, 2, -1]", ":5: [surface] axes = -1: must be > 0"},
      {"axes = [1, 'a', 1]", ":5: [surface] axes = 'a': must be a list of numbers"},
      {"axes = [1, 1, 1e-4]",
       ":5: [surface] axes = [1, 1, 0.0001]: must not differ by more than a factor of 100"},
      {"axes = [1, 1, 1]\nreduced_volume = 1",
       ":6: [surface] reduced_volume = 1: must not be given together with axes"},
      {"axes = [1, 1, 1]\nkind = 'prolate'",
       ":6: [surface] kind = 'prolate': must not be given together with axes, which tell it"},
      {"modes = [[2, 0, 0.1]]",
       ":5: [surface] modes = [[2, 0, 0.1]]: belongs to shape = 'harmonics', not to 'ellipsoid'"},
      {"file = 'a.obj'",
       ":5: [surface] file = 'a.obj': belongs to shape = 'mesh' and 'frame' and 'mode', not to "
       "'ellipsoid'"},
  };
  expect_messages(read_run, "model = \"SBEH\"\ntime.end = 1\n[surface]\nshape = \"ellipsoid\"\n",
                  ellipsoids);
  const std::vector<Case> any{
      {"kind = 'flat'", ":6: [surface] kind = 'flat': must be one of 'oblate', 'prolate'"},
      {"kind = true", ":6: [surface] kind = true: must be one of 'oblate', 'prolate'"},
      {"triangles = 320.0", ":6: [surface] triangles = 320.0: must be an integer"},
      {"triangles = 19", ":6: [surface] triangles = 19: must be >= 20 and <= 200000"},
      {"triangles = 200001", ":6: [surface] triangles = 200001: must be >= 20 and <= 200000"},
      {"triangle = 80",
       ":6: [surface] triangle: unknown key; did you mean 'triangles'? Known: shape, axes, "
       "reduced_volume, kind, triangles, order, order_formula, domains, domain_width, order_modes, "
       "order_noise, perturbation, "
       "symmetry, keep_symmetry"},
      {"order = 'a'", ":6: [surface] order = 'a': must be a number"},
      {"order = -0.1", ":6: [surface] order = -0.1: must be >= 0 and <= 1"},
      {"order = 1.1", ":6: [surface] order = 1.1: must be >= 0 and <= 1"},
      {"perturbation = 0.01", ":6: [surface] perturbation = 0.01: " + modes},
      {"perturbation = []", ":6: [surface] perturbation = []: must not be empty"},
      {"perturbation = [2, 2, 0.01]", ":6: [surface] perturbation = 2: " + modes},
      {"perturbation = [[2, 0.01]]", ":6: [surface] perturbation = [2, 0.01]: " + modes},
      {"perturbation = [[2.0, 2, 0.01]]", ":6: [surface] perturbation = 2.0: " + modes},
      {"perturbation = [[33, 2, 0.01]]", ":6: [surface] perturbation = 33: must be >= 0 and <= 32"},
      {"perturbation = [[2, -3, 0.01]]", ":6: [surface] perturbation = -3: must be >= -2 and <= 2"},
      {"perturbation = [[2, 2, 'a']]", ":6: [surface] perturbation = 'a': " + modes},
      {"perturbation = [[2, 2, nan]]", ":6: [surface] perturbation = nan: must be a finite number"},
      {"perturbation = [[2, 2, 0.1],\n[2, 2, 0.2]]",
       ":7: [surface] perturbation = [2, 2, 0.2]: a harmonic must not be there twice"},
      {"symmetry = 'D3x'",
       ":6: [surface] symmetry = 'D3x': must be C1, Cs, Ci, Cn, Cnv, Cnh, Dn, Dnh, Dnd with n "
       "= 2 ... 12, Sn with an even n = 4 ... 24, T, Td, Th, O, Oh, I or Ih"},
      {"symmetry = 'D3h'\nkeep_symmetry = 'D2'",
       ":7: [surface] keep_symmetry = 'D2': must be part of symmetry = \"D3h\", that of the "
       "triangles"},
      {"keep_symmetry = 'C3'",
       ":6: [surface] keep_symmetry = 'C3': must be part of symmetry = \"C1\", that of the "
       "triangles"},
  };
  expect_messages(read_run, small_run, any);
}

TEST(RunInput, with_a_wrong_start_from_files_is_refused_with_line_key_and_value) {
  const std::string modes =
      "must be a list of [l, m, amplitude], the degree l an integer in 0 ... 32, the order m in -l "
      "... l";
  const std::vector<Case> cases{
      {"'harmonics'", ":3: [surface] modes: missing; " + modes},
      {"'harmonics'\nmodes = [[2, 3, 0.1]]", ":5: [surface] modes = 3: must be >= -2 and <= 2"},
      {"'harmonics'\nmodes = [[2, 0, 0.1]]\nreduced_volume = 2",
       ":6: [surface] reduced_volume = 2: must be > 0 and <= 1"},
      {"'mesh'\nreduced_volume = 0.8",
       ":5: [surface] reduced_volume = 0.8: belongs to shape = 'ellipsoid' and 'harmonics' and "
       "'scan', not to 'mesh'"},
      {"'mesh'", ":3: [surface] file: missing; must be a text in quotes"},
      {"'mesh'\nfile = 3", ":5: [surface] file = 3: must be a text in quotes"},
      {"'mesh'\nfile = ''", ":5: [surface] file = '': must not be empty"},
      {"'mesh'\nfile = 'a.obj'\ntriangles = 80",
       ":6: [surface] triangles = 80: belongs to shape = 'ellipsoid' and 'harmonics' and 'scan' "
       "and 'mode', not to 'mesh'"},
      {"'mode'\nfile = 'm2_even_1.vtu'", ":3: [surface] amplitude: missing; must be a number"},
      {"'mode'\nfile = 'm2_even_1.vtu'\namplitude = inf",
       ":6: [surface] amplitude = inf: must be a finite number"},
      {"'mode'\namplitude = 0.1", ":3: [surface] file: missing; must be a text in quotes"},
      {"'frame'\nfile = 'a.vtu'\namplitude = 0.1",
       ":6: [surface] amplitude = 0.1: belongs to shape = 'mode', not to 'frame'"},
      {"'frame'\nfile = ['a']", ":5: [surface] file = ['a']: must be a text in quotes"},
      {"'frame'\nfile = 'a.vtu'\norder = 0.5",
       ":6: [surface] order = 0.5: belongs to shape = 'ellipsoid' and 'harmonics' and 'mesh', not "
       "to 'frame'"},
      {"'scan'", ":3: [surface] folder: missing; must be a text in quotes"},
      {"'scan'\nfolder = 'out'\nmodel = 'Helfrich-local'",
       ":6: [surface] model = 'Helfrich-local': must be one of 'SBEH', 'SSH'"},
      {"'scan'\nfolder = 'out'\nbranch = 'bud'",
       ":6: [surface] branch = 'bud': must be one of 'oblate', 'prolate', 'stomatocyte', 'pear'"},
      {"'scan'\nfolder = 'out'\nreduced_volume = 2\nL = 1",
       ":6: [surface] reduced_volume = 2: must be > 0 and <= 1"},
      {"'scan'\nfolder = 'out'\nreduced_volume = 0.7\nL = 0", ":7: [surface] L = 0: must be > 0"},
  };
  expect_messages(read_run, "model = \"SBEH\"\ntime.end = 1\n[surface]\nshape = ", cases);
  const std::vector<Case> without_order{
      {"order = 0.5",
       ":6: [surface] order = 0.5: must not be given for model = 'SSH', where the order is 2/3 "
       "everywhere"},
  };
  std::string ssh = small_run;
  expect_messages(read_run, ssh.replace(ssh.find("SBEH"), 4, "SSH"), without_order);
}

TEST(RunInput, with_wrong_times_is_refused_with_line_key_and_value) {
  const std::string start =
      "model = \"SBEH\"\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.8\n[time]\n";
  const std::string grid = "must be a number, a list of numbers, or a range { from, to, count }";
  expect_messages(read_run, start,
                  {{"", ":5: [time] end: missing; must be a number"},
                   {"end = '1'", ":6: [time] end = '1': must be a number"},
                   {"end = 0", ":6: [time] end = 0: must be > 0"},
                   {"end = inf", ":6: [time] end = inf: must be a finite number"},
                   {"ent = 1", ":6: [time] ent: unknown key; did you mean 'end'?"}});
  std::vector<Case> cases{
      {"every_step = 1", ":7: [time] every_step = 1: must be true or false"},
      {"stop_at_rest = 1", ":7: [time] stop_at_rest = 1: must be true or false"},
      {"checkpoint_minutes = '1'", ":7: [time] checkpoint_minutes = '1': must be a number"},
      {"checkpoint_minutes = 0", ":7: [time] checkpoint_minutes = 0: must be > 0"},
      {"checkpoint_minutes = -3", ":7: [time] checkpoint_minutes = -3: must be > 0"},
      {"checkpoint_minutes = inf", ":7: [time] checkpoint_minutes = inf: must be a finite number"},
      {"checkpoint_minute = 1",
       ":7: [time] checkpoint_minute: unknown key; did you mean 'checkpoint_minutes'? Known: end, "
       "output, frames, every_step, stop_at_rest, finish, checkpoint_minutes"},
      {"profiles = [0]",
       ":7: [time] profiles: unknown key. Known: end, output, frames, every_step, stop_at_rest, "
       "finish, checkpoint_minutes"},
  };
  for (const std::string key : {"output", "frames"}) {
    const std::string at = ":7: [time] " + key;
    cases.push_back({key + " = true", fmt::format("{} = true: {}", at, grid)});
    cases.push_back({key + " = []", at + " = []: must not be empty"});
    cases.push_back({key + " = [0, 3]", at + " = 3: must be >= 0 and <= 2"});
    cases.push_back({key + " = -1", at + " = -1: must be >= 0 and <= 2"});
    cases.push_back({key + " = [1, 1]", at + " = 1: must not be there twice"});
    cases.push_back({key + " = {from = 0, to = 2, count = 3, spacing = 'log'}",
                     at + ".from = 0: must be > 0 for spacing = 'log'"});
  }
  expect_messages(read_run, start + "end = 2\n", cases);
}

TEST(RunInput, with_wrong_numerics_is_refused_with_line_key_and_value) {
  std::vector<Case> cases{
      {"extrapolate = 1", ":7: [numerics] extrapolate = 1: must be true or false"},
      {"extrapolate = false",
       ":7: [numerics] extrapolate = false: must be true with integrator = 'multi-step', which is "
       "of "
       "second order at least"},
      {"scheme = 'spilt'", ":7: [numerics] scheme = 'spilt': must be one of 'split', 'monolithic'"},
      {"scheme = 1", ":7: [numerics] scheme = 1: must be one of 'split', 'monolithic'"},
      {"solver_tolerance = 1", ":7: [numerics] solver_tolerance = 1: must be in 1e-12 ... 0.01"},
      {"factorisation = 'never'",
       ":7: [numerics] factorisation = 'never': must be one of 'lagged', 'every-step'"},
      {"tolerance = 0.2", ":7: [numerics] tolerance = 0.2: must be in 1e-12 ... 0.1"},
      {"first_step = 11\nlargest_step = 11",
       ":7: [numerics] first_step = 11: must be in 1e-14 ... 10"},
      {"smallest_step = 2", ":7: [numerics] smallest_step = 2: must be in 1e-16 ... 1"},
      {"largest_step = 1e4", ":7: [numerics] largest_step = 10000: must be in 1e-14 ... 1000"},
      {"rest_speed = 2", ":7: [numerics] rest_speed = 2: must be in 1e-14 ... 1"},
      {"first_step = 1\nlargest_step = 0.1",
       ":8: [numerics] largest_step = 0.1: must be >= first_step and smallest_step"},
      {"elements = 48",
       ":7: [numerics] elements: unknown key. Known: tolerance, first_step, smallest_step, "
       "largest_step, extrapolate, rest_speed, integrator, scheme, factorisation, "
       "solver_tolerance, remesh, most_triangles"},
      {"factorization = 'lagged'",
       ":7: [numerics] factorization: unknown key; did you mean 'factorisation'? Known: tolerance, "
       "first_step, smallest_step, largest_step, extrapolate, rest_speed, integrator, scheme, "
       "factorisation, "
       "solver_tolerance, remesh, most_triangles"},
  };
  for (const std::string key :
       {"tolerance", "first_step", "smallest_step", "largest_step", "rest_speed"}) {
    cases.push_back({key + " = 'a'", ":7: [numerics] " + key + " = 'a': must be a number"});
    cases.push_back({key + " = nan", ":7: [numerics] " + key + " = nan: must be a finite number"});
  }
  expect_messages(read_run, small_run + "[numerics]\n", cases);
}

TEST(RunInput, with_wrong_tables_is_refused_with_what_was_meant) {
  expect_messages(
      read_run, small_run,
      {{"[numeric]",
        ":6: [numeric]: unknown table; did you mean 'numerics'? Known: model, surface, "
        "time, material, numerics, units"},
       {"[start]",
        ":6: [start]: unknown table. Known: model, surface, time, material, numerics, units"}});
  expect_messages(
      read_run, "",
      {{"time.end = 1",
        ": model: missing at the top of the file; must be one of 'SBEH', 'SSH', "
        "'Helfrich-local', 'Helfrich-global'"},
       {"model = 'sbeh'",
        ":1: model = 'sbeh': must be one of 'SBEH', 'SSH', 'Helfrich-local', 'Helfrich-global'"},
       {"model = 'SBEH'\nsurface = 3", ":2: surface = 3: must be a table"}});
}

}  // namespace
}  // namespace sbeh::studies
