// Inputs of scans and evolutions: what is read, and what is refused with which words.
#include "studies/evolution/relax_input.h"
#include "studies/scan/scan_input.h"
#include "tests/studies/parameters/input_file.h"

#include <algorithm>

namespace sbeh::studies {
namespace {

using namespace test;

using model::Model;

ScanInput scan_of(const std::string& text) { return read_scan(written(text)); }
RelaxInput relax_of(const std::string& text) { return read_relax(written(text)); }

// ---- scans --------------------------------------------------------------------------------------

TEST(ScanInput, has_the_documented_defaults) {
  const ScanInput input = scan_of(small_scan);
  EXPECT_EQ(input.reduced_volume, std::vector{0.7});
  EXPECT_EQ(input.L, std::vector{0.05});
  EXPECT_EQ(input.models, (std::vector{Model::SBEH, Model::SSH}));
  EXPECT_EQ(input.branches, std::vector{axisym::Branch::oblate});
  EXPECT_EQ(input.method, Method::newton);
  EXPECT_EQ(input.flow_end_time, 200);
  EXPECT_FALSE(input.beyond_fold);
  EXPECT_EQ(input.material, model::Material{});
  EXPECT_EQ(input.numerics, axisym::Numerics{});
}

TEST(ScanInput, takes_what_the_file_says) {
  const ScanInput input = scan_of(
      "[scan]\nreduced_volume = [0.8, 0.6]\nL = { from = 0.01, to = 0.05, count = 5 }\n"
      "models = [\"SSH\"]\nbranches = [\"oblate\"]\nmethod = \"flow\"\nend_time = 50\n"
      "[material]\nviscosity = 2\n[numerics]\nelements = 32\nextrapolate = false\n");
  EXPECT_EQ(input.reduced_volume, (std::vector{0.6, 0.8}));
  EXPECT_EQ(input.L, (std::vector{0.01, 0.02, 0.03, 0.04, 0.05}));
  EXPECT_EQ(input.models, std::vector{Model::SSH});
  EXPECT_EQ(input.method, Method::flow);
  EXPECT_EQ(input.flow_end_time, 50);
  EXPECT_EQ(input.material.viscosity, 2);
  EXPECT_EQ(input.numerics.elements, 32);
  EXPECT_FALSE(input.numerics.extrapolate);
}

TEST(ScanInput, that_is_wrong_is_refused_with_line_key_and_value) {
  const std::string known =
      "Known: reduced_volume, L, axes, models, branches, method, further, end_time, beyond_fold, "
      "modes, order_formula, domains, domain_width";
  const std::string grid = "must be a number, a list of numbers, or a range { from, to, count }";
  const std::vector<Case> added{
      {"models = 'SSH'",
       ":4: [scan] models = 'SSH': must be a list of words out of ['SBEH', 'SSH']"},
      {"models = ['ssh']", ":4: [scan] models = 'ssh': must be one of 'SBEH', 'SSH'"},
      {"models = ['SSH', 'Helfrich-local']",
       ":4: [scan] models = 'Helfrich-local': must not be scanned: its states of rest are those of "
       "SSH"},
      {"models = ['Helfrich-global']",
       ":4: [scan] models = 'Helfrich-global': must not be scanned: its states of rest are those "
       "of SSH"},
      {"models = [3]", ":4: [scan] models = 3: must be one of 'SBEH', 'SSH'"},
      {"models = []", ":4: [scan] models = []: must not be empty"},
      {"models = ['SSH', 'SSH']", ":4: [scan] models = 'SSH': must not be there twice"},
      {"branches = ['bud']",
       ":4: [scan] branches = 'bud': must be one of 'oblate', 'prolate', 'stomatocyte', 'pear'"},
      {"method = 'fast'", ":4: [scan] method = 'fast': must be one of 'newton', 'flow'"},
      {"method = 1", ":4: [scan] method = 1: must be one of 'newton', 'flow'"},
      {"end_time = 3", ":4: [scan] end_time = 3: must not be given without method = 'flow'"},
      {"method = 'flow'\nend_time = 0", ":5: [scan] end_time = 0: must be > 0"},
      {"beyond_fold = 1", ":4: [scan] beyond_fold = 1: must be true or false"},
      {"beyond_fold = true\nmodels = ['SSH']",
       ":4: [scan] beyond_fold = true: needs method = \"newton\", the model \"SBEH\" and the "
       "branch "
       "\"oblate\""},
      {"beyond_fold = true\nmethod = 'flow'",
       ":4: [scan] beyond_fold = true: needs method = \"newton\", the model \"SBEH\" and the "
       "branch "
       "\"oblate\""},
      {"\nl = 0.3", ":5: [scan] l: unknown key; did you mean 'L'? " + known},
      {"zzz = 0\nyyy = 0\nxxxxxxx = 1", ":4: [scan] zzz: unknown key. " + known},
      {"[scan.extra]", ":4: [scan.extra]: unknown table. " + known},
      {"[materials]",
       ":4: [materials]: unknown table; did you mean 'material'? Known: scan, material, numerics, "
       "units"},
      {"[start]", ":4: [start]: unknown table. Known: scan, material, numerics, units"},
  };
  expect_messages(read_scan, small_scan, added);
  const std::vector<Case> whole{
      {"", ": [scan] reduced_volume: missing; " + grid},
      {"\n[scan]\nL = 1", ":2: [scan] reduced_volume: missing; " + grid},
      {"[scan]\nL = 1\nreduced_volum = 0.7",
       ":3: [scan] reduced_volum: unknown key; did you mean 'reduced_volume'?"},
      {"[scan]\nl = 1\nreduced_volume = 0.7", ":2: [scan] l: unknown key; did you mean 'L'?"},
      {"[scan]\n\nreduced_volume = 1.1\nL = 0.05",
       ":3: [scan] reduced_volume = 1.1: must be > 0 and <= 1"},
      {"[scan]\nreduced_volume = [0.7, 0]\nL = 0.05",
       ":2: [scan] reduced_volume = 0: must be > 0 and <= 1"},
      {"[scan]\nreduced_volume = 0.7\nL = -0.1", ":3: [scan] L = -0.1: must be > 0"},
      {"[scan]\nreduced_volume = 'a'\nL = 0.1", ":2: [scan] reduced_volume = 'a': " + grid},
      {"[scan]\nreduced_volume = { from = 0.6, to = 1.2, count = 3 }\nL = 0.1",
       ":2: [scan] reduced_volume.to = 1.2: must be > 0 and <= 1"},
      {"[scan.reduced_volume]\nfrom = 0.6\nto = 1.2\ncount = 3\n[scan]\nL = 0.1",
       ":3: [scan.reduced_volume] to = 1.2: must be > 0 and <= 1"},
      {"scan = 3", ":1: scan = 3: must be a table"},
      {"[[scan]]\nL = 1", ":1: scan = [{ L = 1 }]: must be a table"},
      {"reduced_volume = 0.7\n[scan]\nL = 1",
       ":1: reduced_volume: unknown key. It has its place in [scan]. Known here: scan, material, "
       "numerics, units"},
      {"[scan]\nreduced_volume = 0.7\nL = 1\nviscosity = 2",
       ":4: [scan] viscosity: unknown key. It has its place in [material]. Known here: "
       "reduced_volume, L, axes, models, branches, method, further, end_time, beyond_fold, modes, "
       "order_formula, domains, domain_width"},
  };
  expect_messages(read_scan, "", whole);
}

// ---- evolutions ---------------------------------------------------------------------------------

TEST(RelaxInput, has_the_documented_defaults) {
  const RelaxInput input = relax_of(small_relax);
  EXPECT_EQ(input.model, Model::SBEH);
  const auto& ellipsoid = std::get<Ellipsoid>(input.start);
  EXPECT_EQ(ellipsoid.reduced_volume, 0.7);
  EXPECT_TRUE(ellipsoid.axes.empty());
  EXPECT_FALSE(ellipsoid.prolate);
  EXPECT_EQ(input.initial_order, model::full_order);
  EXPECT_EQ(input.times.end, 10);
  EXPECT_FALSE(input.times.every_step);
  EXPECT_TRUE(input.times.stop_at_rest);
  EXPECT_EQ(input.material, model::Material{});
  EXPECT_EQ(input.numerics, axisym::Numerics{});
}

TEST(RelaxInput, has_output_times_in_equal_ratios_unless_told) {
  for (const double end : {1e-4, 10.0, 1.0 / 3, 1e4}) {
    const std::vector<double> output = default_row_times(end);
    const std::vector<double> profiles = default_state_times(end);
    const double ratio = std::pow(10, 1. / 32);
    EXPECT_NEAR(output[2] / output[1], ratio, 1e-12);
    EXPECT_GE(output[1], std::min(1e-5, end / 100) * (1 - 1e-9));
    EXPECT_LT(output[1], std::min(1e-5, end / 100) * ratio);
    EXPECT_LE(end / output[output.size() - 2], ratio * (1 + 1e-9));
    EXPECT_EQ(profiles.size(), 8u);
    EXPECT_NEAR(profiles[2] / profiles[1], end / profiles[6], 1e-9);
    for (const auto& times : {output, profiles}) {
      EXPECT_EQ(times.front(), 0);
      EXPECT_EQ(times.back(), end);
      EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
    }
    const std::vector<double> longer = default_row_times(10 * end);
    for (const double time : output) {
      if (time < longer[1] || time == end) continue;
      EXPECT_TRUE(std::ranges::binary_search(longer, time)) << time;
    }
  }
}

// Steps to 0.1, 0.3, 0.35, 1, 2.
TEST(Times, without_output_a_row_is_due_at_the_end_of_each_step_that_passes_one) {
  Times times{.end = 3, .rows = {0, 0.2, 0.25, 1, 3}, .exact_rows = false, .states = {}};
  const auto due = [&](double from, double to) {
    model::FlowRecord record;
    record.time = to;
    record.time_step = to - from;
    return row_is_due(times, record, false);
  };
  EXPECT_TRUE(due(0, 0));
  EXPECT_FALSE(due(0, 0.1));
  EXPECT_TRUE(due(0.1, 0.3));
  EXPECT_FALSE(due(0.3, 0.35));
  EXPECT_TRUE(due(0.35, 1));
  EXPECT_FALSE(due(1, 2));
  EXPECT_EQ(schedule_of(times).output_times, std::vector{0.});
  times.exact_rows = true;
  EXPECT_FALSE(due(0.1, 0.3));
  EXPECT_EQ(schedule_of(times).output_times, times.rows);
}

TEST(RelaxInput, takes_an_ellipsoid_with_axes_and_order) {
  const RelaxInput input = relax_of(
      "model = \"SBEH\"\n[start]\nshape = \"ellipsoid\"\naxes = [1.2, 0.5]\norder = 0.6667\n"
      "[time]\nend = 2\noutput = { from = 0.01, to = 1, count = 3, spacing = \"log\" }\n"
      "profiles = [2, 0]\nevery_step = true\nstop_at_rest = false\n");
  EXPECT_EQ(std::get<Ellipsoid>(input.start).axes, (std::vector{1.2, 0.5}));
  EXPECT_EQ(input.initial_order, 0.6667);
  EXPECT_EQ(input.times.rows, (std::vector{0.01, 0.1, 1.0}));
  EXPECT_EQ(input.times.states, (std::vector{0.0, 2.0}));
  EXPECT_TRUE(input.times.every_step);
  EXPECT_FALSE(input.times.stop_at_rest);
}

TEST(RelaxInput, takes_harmonics_of_shape_and_order) {
  const RelaxInput input = relax_of(
      "model = \"SBEH\"\n[start]\nshape = \"harmonics\"\nmodes = [[2, 0.04], [3, -1]]\n"
      "order_modes = [[2, 0.001]]\n[time]\nend = 2\n");
  const auto& harmonics = std::get<Harmonics>(input.start);
  EXPECT_EQ(harmonics.shape, (std::vector<axisym::Mode>{{2, 0.04}, {3, -1}}));
  EXPECT_EQ(harmonics.order, std::nullopt);
  EXPECT_EQ(harmonics.order_modes, (std::vector<axisym::Mode>{{2, 0.001}}));
}

TEST(RelaxInput, takes_harmonics_of_a_reduced_volume_and_a_perturbation) {
  const RelaxInput input = relax_of(
      "model = \"SBEH\"\n[start]\nshape = \"harmonics\"\nmodes = [[2, 0.04]]\n"
      "reduced_volume = 0.95\nperturbation = [[3, -0.01], [1, 2]]\n[time]\nend = 2\n");
  EXPECT_EQ(std::get<Harmonics>(input.start).reduced_volume, 0.95);
  EXPECT_EQ(input.perturbation, (std::vector<axisym::Mode>{{3, -0.01}, {1, 2}}));
  for (const std::string& shape : std::vector<std::string>{
           "\"ellipsoid\"\nreduced_volume = 0.7", "\"harmonics\"\nmodes = [[2, 0.04]]",
           "\"scan\"\nfolder = \"" + scan_folder("") + "\"\nreduced_volume = 0.7\nL = 0.03"})
    EXPECT_EQ(relax_of("model = \"SBEH\"\ntime.end = 2\n[start]\nshape = " + shape
                       + "\nperturbation = [[2, 0.02]]\n")
                  .perturbation,
              (std::vector<axisym::Mode>{{2, 0.02}}));
}

TEST(RelaxInput, from_a_scan_has_the_material_of_the_scan_with_the_rows_L) {
  const std::string folder = scan_folder("[material]\nspontaneous_curvature = -2.7\n");
  const std::string head = "[start]\nshape = \"scan\"\nfolder = \"" + folder
                         + "\"\nreduced_volume = 0.7\nL = 0.03\n",
                    time = "[time]\nend = 2\n", start = "model = \"SSH\"\n" + head + time;
  const RelaxInput input = relax_of(start);
  const auto& row = std::get<ScanRow>(input.start);
  EXPECT_EQ(row.folder, folder);
  EXPECT_EQ(row.model, Model::SSH);
  EXPECT_EQ(row.branch, axisym::Branch::oblate);
  EXPECT_EQ(row.reduced_volume, 0.7);
  EXPECT_EQ(row.L, 0.03);
  EXPECT_EQ(input.material.L1, 0.03);
  EXPECT_EQ(input.material.spontaneous_curvature, -2.7);
  for (const char* table : {"[material]\nL = 0.04", "[material]\nL1 = 0.04"}) {
    const RelaxInput changed = relax_of(start + table);
    EXPECT_EQ(changed.material.L1, 0.04);
    EXPECT_EQ(changed.material.spontaneous_curvature, -2.7);
  }
  EXPECT_EQ(relax_of(start + "[material]\nspontaneous_curvature = 0").material,
            model::Material{}.with_L(0.03));
  // The row's model is enough; another one above it is a change.
  const RelaxInput of_row = relax_of(head + "model = \"SSH\"\n" + time);
  EXPECT_EQ(of_row.model, Model::SSH);
  EXPECT_EQ(of_row.material, input.material);
  EXPECT_EQ(relax_of("model = \"SBEH\"\n" + head + "model = \"SSH\"\n" + time).model, Model::SBEH);
  expect_messages(read_relax, head + time,
                  {{"",
                    ": model: missing at the top of the file; must be one of 'SBEH', 'SSH', "
                    "'Helfrich-local', 'Helfrich-global'"}});
}

TEST(RelaxInput, with_a_wrong_start_is_refused_with_line_key_and_value) {
  const std::string pairs =
      "must be a list of pairs [degree, amplitude], the degree an integer in 1 ... 32";
  const std::vector<Case> starts{
      {"'cube'", ":3: [start] shape = 'cube': must be one of 'ellipsoid', 'harmonics', 'scan'"},
      {"'ellipsoid'", ":2: [start] reduced_volume: missing; must be a number"},
      {"'ellipsoid'\nreduced_volume = 2", ":4: [start] reduced_volume = 2: must be > 0 and <= 1"},
      {"'ellipsoid'\nreduced_volume = 0.7\naxes = [1, 2]",
       ":4: [start] reduced_volume = 0.7: must not be given together with axes"},
      {"'ellipsoid'\naxes = [1, 2]\nkind = 'oblate'",
       ":5: [start] kind = 'oblate': must not be given together with axes, which tell it"},
      {"'ellipsoid'\naxes = [1, 2, 3]",
       ":4: [start] axes = [1, 2, 3]: must be two numbers, equatorial and polar semi-axis"},
      {"'ellipsoid'\naxes = [1, 0]", ":4: [start] axes = 0: must be > 0"},
      {"'ellipsoid'\nreduced_volume = 0.7\nkind = 'flat'",
       ":5: [start] kind = 'flat': must be one of 'oblate', 'prolate'"},
      {"'ellipsoid'\nreduced_volume = 0.7\norder = -0.1",
       ":5: [start] order = -0.1: must be >= 0 and <= 1"},
      {"'ellipsoid'\nmodes = [[2, 0.1]]",
       ":4: [start] modes = [[2, 0.1]]: belongs to shape = 'harmonics', not to 'ellipsoid'"},
      {"'harmonics'\nmodes = [[2, 0.1]]\nreduced_volume = 2",
       ":5: [start] reduced_volume = 2: must be > 0 and <= 1"},
      {"'harmonics'\norder_modes = [[2, 0.1]]\nreduced_volume = 0.9",
       ":5: [start] reduced_volume = 0.9: needs modes, whose amplitudes it multiplies by one "
       "factor"},
      {"'harmonics'\nmodes = [[2, 0.1]]\naxes = [1, 2]",
       ":5: [start] axes = [1, 2]: belongs to shape = 'ellipsoid', not to 'harmonics'"},
      {"'scan'\nfolder = 'a'\nreduced_volume = 0.7\nL = 0.1\nperturbation = [[2, 0, 0.1]]",
       ":7: [start] perturbation = [2, 0, 0.1]: " + pairs},
      {"'scan'\norder = 0.5",
       ":4: [start] order = 0.5: belongs to shape = 'ellipsoid' and 'harmonics', not to 'scan'"},
      {"'ellipsoid'\nreduced_volume = 0.7\nknid = 'prolate'",
       ":5: [start] knid: unknown key; did you mean 'kind'? Known: shape, axes, reduced_volume, "
       "kind, order, order_formula, domains, domain_width, perturbation"},
      {"'harmonics'", ":2: [start] modes: missing; " + pairs},
      {"'harmonics'\nmodes = []", ":4: [start] modes = []: must not be empty"},
      {"'harmonics'\nmodes = [2, 0.1]", ":4: [start] modes = 2: " + pairs},
      {"'harmonics'\nmodes = [[2]]", ":4: [start] modes = [2]: " + pairs},
      {"'harmonics'\nmodes = [[2.0, 1]]", ":4: [start] modes = 2.0: " + pairs},
      {"'harmonics'\nmodes = [[33, 1]]", ":4: [start] modes = 33: must be >= 1 and <= 32"},
      {"'harmonics'\nmodes = [[2, nan]]", ":4: [start] modes = nan: must be a finite number"},
      {"'harmonics'\nmodes = [[2, 1],\n[2, 3]]",
       ":5: [start] modes = [2, 3]: degree must not be there twice"},
      {"'harmonics'\norder_modes = 1", ":4: [start] order_modes = 1: " + pairs},
      {"'scan'", ":2: [start] folder: missing; must be a text in quotes"},
      {"'scan'\nfolder = ''", ":4: [start] folder = '': must not be empty"},
      {"'scan'\nfolder = 'a'\nbranch = 'b'",
       ":5: [start] branch = 'b': must be one of 'oblate', 'prolate', 'stomatocyte', 'pear'"},
      {"'scan'\nfolder = 'a'\nreduced_volume = 0.7\nL = 0", ":6: [start] L = 0: must be > 0"},
  };
  expect_messages(read_relax, "model = \"SBEH\"\n[start]\nshape = ", starts);
  const std::vector<Case> starts_in_ssh{
      {"'ellipsoid'\norder = 0.5",
       ":4: [start] order = 0.5: must not be given for model = 'SSH', where the order is 2/3 "
       "everywhere"},
  };
  expect_messages(read_relax, "model = \"SSH\"\n[start]\nshape = ", starts_in_ssh);
}

TEST(RelaxInput, of_a_Helfrich_flow_has_no_order_no_viscosity_and_its_own_friction) {
  const std::string start =
      "model = \"Helfrich-global\"\ntime.end = 1\nstart = { shape = \"ellipsoid\", ";
  const RelaxInput input = relax_of(start + "reduced_volume = 0.7 }\n[material]\nL = 0.03\n");
  EXPECT_EQ(input.model, Model::HelfrichGlobal);
  EXPECT_EQ(input.material.L1, 0.03);
  EXPECT_EQ(relax_of("model = \"Helfrich-local\"\ntime.end = 1\n[start]\nshape = \"ellipsoid\"\n"
                     "reduced_volume = 0.7\n")
                .model,
            Model::HelfrichLocal);
  const std::string own =
      ": must not be given for model = 'Helfrich-global', which has no viscosity and friction 1";
  const std::vector<Case> given{
      {"reduced_volume = 0.7, order = 0.5 }",
       ":3: start.order = 0.5: must not be given for model = 'Helfrich-global', where the order is "
       "2/3 everywhere"},
      {"reduced_volume = 0.7 }\n[material]\nviscosity = 2", ":5: [material] viscosity = 2" + own},
      {"reduced_volume = 0.7 }\n[material]\nfriction = 1", ":5: [material] friction = 1" + own},
      {"reduced_volume = 0.7 }\n[material]\nfriction_normal = 1",
       ":5: [material] friction_normal = 1" + own},
  };
  expect_messages(read_relax, start, given);
  // A scan has no states of this flow, but SSH's.
  const RelaxInput row = relax_of(
      "model = \"Helfrich-local\"\ntime.end = 1\n[start]\nshape = \"scan\"\nfolder = \""
      + scan_folder("[material]\nviscosity = 7\n") + "\"\nreduced_volume = 0.7\nL = 0.03\n");
  EXPECT_EQ(std::get<ScanRow>(row.start).model, Model::SSH);
  EXPECT_EQ(row.material,
            model::Material{}.with_L(0.03));  // the scan's viscosity is not this flow's
}

TEST(RelaxInput, with_a_wrong_time_or_model_is_refused_with_line_key_and_value) {
  const std::string start = "start = { shape = \"ellipsoid\", reduced_volume = 0.7 }\n";
  const std::vector<Case> times{
      {"", ": [time] end: missing; must be a number"},
      {"[time]", ":3: [time] end: missing; must be a number"},
      {"[time]\nend = 0", ":4: [time] end = 0: must be > 0"},
      {"[time]\nend = 3\noutput = [1, 4]", ":5: [time] output = 4: must be >= 0 and <= 3"},
      {"[time]\nend = 3\nprofiles = -1", ":5: [time] profiles = -1: must be >= 0 and <= 3"},
      {"[time]\nend = 3\nstop_at_rest = 'no'",
       ":5: [time] stop_at_rest = 'no': must be true or false"},
      {"[time]\nend = 3\nprofile = 3",
       ":5: [time] profile: unknown key; did you mean 'profiles'? Known: end, output, profiles, "
       "every_step, stop_at_rest"},
      {"[tiem]\nend = 3",
       ":3: [tiem]: unknown table; did you mean 'time'? Known: model, start, time, material, "
       "numerics, units"},
      {"strat.shape = 'scan'",
       ":3: [strat]: unknown table; did you mean 'start'? Known: model, start, time, material, "
       "numerics, units"},
  };
  expect_messages(read_relax, "model = \"SBEH\"\n" + start, times);
  const std::string models_known = "'SBEH', 'SSH', 'Helfrich-local', 'Helfrich-global'";
  const std::vector<Case> models{
      {start, ": model: missing at the top of the file; must be one of " + models_known},
      {"model = 'sbeh'", ":1: model = 'sbeh': must be one of " + models_known},
      {"model = 'SSH'\nstart = { shap = 'scan' }",
       ":2: start.shap: unknown key; did you mean 'shape'?"},
  };
  expect_messages(read_relax, "", models);
}

// ---- the inputs that come with the toolkit ------------------------------------------------------

TEST(SuppliedInput, of_every_kind_can_be_read) {
  for (const char* file : {"studies/inputs/paper_scan.toml", "studies/inputs/paper_flow.toml"}) {
    const ScanInput paper = read_scan(file);
    EXPECT_EQ(paper.reduced_volume, (std::vector{0.6, 0.7, 0.8}));
    EXPECT_EQ(paper.L, (std::vector{0.01, 0.03, 0.05, 0.07}));
    EXPECT_EQ(paper.models.size(), 2u);
  }
  EXPECT_EQ(read_scan("studies/inputs/paper_flow.toml").method, Method::flow);
  EXPECT_EQ(read_scan("studies/inputs/map.toml").L.size(), 50u);
  EXPECT_EQ(read_scan("studies/inputs/map.toml").reduced_volume.size(), 50u);
  EXPECT_EQ(
      std::get<Ellipsoid>(read_relax("studies/inputs/relax_oblate.toml").start).reduced_volume,
      0.7);
  EXPECT_EQ(
      std::get<Harmonics>(read_relax("studies/inputs/relax_two_modes.toml").start).shape.size(),
      2u);
}

}  // namespace
}  // namespace sbeh::studies
