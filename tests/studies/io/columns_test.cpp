// Tables by their lists of columns: what stands in a file, and that it is read back as it was.
#include "studies/compare/compare.h"
#include "studies/evolution/evolution_files.h"
#include "studies/figures/figures.h"
#include "studies/io/growing_table.h"
#include "studies/modes/modes.h"
#include "studies/scan/beyond_fold.h"
#include "studies/scan/branch_lines.h"
#include "studies/scan/lowest.h"
#include "studies/scan/stability_lines.h"
#include "studies/seifert/seifert.h"
#include "studies/stability/stability.h"
#include "studies/states/profile_file.h"
#include "studies/states/series_file.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

namespace sbeh::studies {
namespace {

enum class Colour { red, green };
constexpr auto names(Colour) { return std::array{"red", "green"}; }

struct Part {
  double value = 0, error = 0;
};
struct Row {
  int key = 0;
  double length = 0, width = 0;
  bool round = false;
  Colour colour{};
  std::string remark;
  std::optional<double> weight;
  std::optional<Part> part;
};

const Columns<Row>& columns() {
  static const Columns<Row> all{
      column("index", &Row::key),
      column("r", &Row::length),
      known_column("z", &Row::width, "{:.3g}"),
      column("self_contact", &Row::round),
      column("kind", &Row::colour),
      column("remark", &Row::remark),
      column("energy", &Row::weight),
      part_column("pressure", &Row::part, &Part::value, ""),
      part_column("error", &Row::part, &Part::error, "", "{:.2g}"),
      derived_column<Row>("arc_length",
                          [](const Row& row) { return fmt::format("{}", 2 * row.length); }),
  };
  return all;
}

const std::vector<Row>& rows() {
  static const std::vector<Row> all{
      {1, 0.1, not_known, true, Colour::green, "one, \"two\"", {}, {}},
      {2, 1. / 3, 2.5, false, Colour::red, "", 7, Part{1e-300, 0.5}},
  };
  return all;
}

TEST(Columns, give_header_and_lines) {
  EXPECT_EQ(table_text(columns(), rows()),
            "index,r,z,self_contact,kind,remark,energy,pressure,error,arc_length\n"
            "1,0.1,,1,green,\"one, \"\"two\"\"\",,,,0.2\n"
            "2,0.3333333333333333,2.5,0,red,,7,1e-300,0.5,0.6666666666666666\n");
}

TEST(Columns, read_back_what_they_have_written_in_any_order_and_without_some) {
  const sbeh::test::TemporaryFolder folder;
  const auto file = folder.path() / "table.csv";
  write_file(file, table_text(columns(), rows()));
  const auto same = read_rows(columns(), file);
  EXPECT_EQ(table_text(columns(), same), table_text(columns(), rows()));
  EXPECT_FALSE(same[0].part);
  EXPECT_TRUE(std::isnan(same[0].width));

  write_file(file, "energy,other,r\n,x,3\n");
  const auto some = read_rows(columns(), file);
  ASSERT_EQ(some.size(), 1u);
  EXPECT_EQ(some[0].length, 3);
  EXPECT_FALSE(some[0].weight);
}

TEST(Columns, name_line_and_column_of_a_damaged_field) {
  const sbeh::test::TemporaryFolder folder;
  const auto file = folder.path() / "table.csv";
  for (const auto& [field, text] :
       {std::pair("r", "3 m"), {"self_contact", "yes"}, {"kind", "blue"}, {"energy", "x"}}) {
    write_file(file, fmt::format("index,{}\n1,{}\n", field, text));
    try {
      read_rows(columns(), file);
      ADD_FAILURE() << field;
    } catch (const OutputError& error) {
      EXPECT_EQ(error.what(), fmt::format("{}:2: {} = '{}' is damaged: compute it again",
                                          file.string(), field, text));
    }
  }
}

// So that none can be forgotten in the list of dimensions.
TEST(Columns, without_a_known_dimension_are_refused) {
  const Columns<Row> unknown{column("index", &Row::key), column("weight_of_cheese", &Row::length)};
  EXPECT_THROW(header_of(unknown), std::logic_error);
  EXPECT_THROW(table_text(unknown, std::vector<Row>{}), std::logic_error);
}

TEST(GrowingTable, goes_on_after_a_line_that_was_cut_off_and_refuses_another_table) {
  const sbeh::test::TemporaryFolder folder;
  const auto file = folder.path() / "table.csv";
  const auto open = [&] { return GrowingTable<Row>(file, columns(), "tests", "it again"); };
  {
    auto table = open();
    table.append(rows()[1]);
    table.append(rows()[0]);
  }
  write_file(file, read_file(file) + "3,0.");
  {
    const auto table = open();
    EXPECT_EQ(table.rows().size(), 2u);
    EXPECT_EQ(table.find(2)->length, 1. / 3);
    EXPECT_FALSE(table.find(3));
  }
  EXPECT_EQ(read_file(file), table_text(columns(), rows()));  // in the order of the keys
  write_file(file, read_file(file) + "3,0.1\n");
  EXPECT_THROW(open(), OutputError);
  write_file(file, "index,other\n");
  EXPECT_THROW(open(), OutputError);
}

// What users and their scripts rely on.
TEST(Tables, have_these_columns) {
  const auto expect = [](const auto& columns, const char* header) {
    EXPECT_EQ(header_of(columns), header);
  };
  expect(scan_columns(),
         "model,reduced_volume,L,branch,status,energy,energy_distortion,energy_bending,"
         "energy_thermotropic,energy_area_difference,order_min,order_max,order_mean,order_std,"
         "order_variance,H_pole,H_rim,"
         "H_abs_max,radius_equator,thickness_pole,W2,area,volume,residual,steps,wall_seconds,"
         "stop_reason,class,negative_directions,self_contact,fold_side,fold_L,"
         "energy_error,W2_error,H_pole_error,fold_L_error,interfaces,fold_reduced_volume,"
         "fold_reduced_volume_error,negative_directions_3d,unstable_modes,"
         "rigid_residual,"
         "eigenvalue_m0,eigenvalue_m1,eigenvalue_m2,eigenvalue_m3,eigenvalue_m4,eigenvalue_m5,"
         "eigenvalue_m6,rate_m0,rate_m1,rate_m2,rate_m3,rate_m4,rate_m5,rate_m6");
  expect(fold_columns(),
         "reduced_volume,L,energy,order_min,H_abs_max,branch,kind,L_error,energy_error,reduced_"
         "volume_error");
  expect(equal_energy_columns(), "first,second,L,reduced_volume,energy");
  expect(lowest_columns(),
         "model,L,reduced_volume,branch,energy,bound,bound_of,negative_directions_3d");
  expect(stability_line_columns(), "model,branch,m,parity,along,reduced_volume,L,error,reason");
  expect(rim_columns(),
         "reduced_volume,L,kind,energy,order_rim,H_rim,H_abs_max,resolution,status,jump,pressure,"
         "negative_directions,negative_directions_3d,unstable_modes,rigid_residual,"
         "eigenvalue_m0,eigenvalue_m1,eigenvalue_m2,eigenvalue_m3,eigenvalue_m4,eigenvalue_m5,"
         "eigenvalue_m6,rate_m0,rate_m1,rate_m2,rate_m3,rate_m4,rate_m5,rate_m6");
  expect(profile_columns(), "arc_length,r,z,order,mean_curvature");
  expect(series_columns(),
         "time,time_step,energy,energy_distortion,energy_bending,energy_thermotropic,"
         "energy_area_difference,dissipation_friction,dissipation_order,dissipation_viscous,energy_"
         "balance,area,volume,"
         "reduced_volume,W2,order_min,order_mean,order_max,order_variance,order_std,domains,domain_"
         "area,"
         "domain_boundary,H_abs_max,"
         "speed_max,lambda,mesh_quality,asymmetry,rejected_steps");
  expect(frame_columns(), "index,time,file");
  expect(comparison_columns(),
         "quantity,first,second,first_value,second_value,difference,relative_difference,tolerance,"
         "agrees");
  expect(method_columns(),
         "method,status,energy,energy_distortion,energy_bending,energy_thermotropic,pressure,"
         "tension,order_min,order_mean,order_max,H_pole,seconds,remark");
  expect(placed_columns(), "method,arc_length,r,z,order,distance");
  expect(history_columns(), "method,time,energy");
  expect(branch_columns(),
         "witness,branch,reduced_volume,energy_reduced,H_pole,pressure,tension,"
         "negative_directions,self_contact,negative_directions_3d,unstable_modes,eigenvalue_m0,"
         "eigenvalue_m1,eigenvalue_m2,eigenvalue_m3,eigenvalue_m4");
  expect(classical_threshold_columns(), "branch,m,parity,reduced_volume,energy_reduced,error");
  expect(point_columns(), "name,reduced_volume,energy_reduced,error");
  expect(witness_point_columns(), "witness,name,reduced_volume,energy_reduced,error");
  expect(disagreement_columns(), "first,second,branch,energy_reduced,H_pole,pressure,tension");
  expect(stability_columns(),
         "model,reduced_volume,L,branch,l,m,verdict,witness,eigenvalue,mode_rate,end_state,rate,"
         "rate_error,coarser_rate,fit_from,fit_to,rate_difference,reduced_rate,amplitude_start,"
         "amplitude_end,"
         "energy_axisymmetric,energy_end,energy_oblate,"
         "energy_prolate,end_time,steps,triangles,unresolved_from,negative_directions,stiffness,"
         "wall_seconds,stop_reason");
  expect(perturbed_columns(), "time,time_step,energy,amplitude,normal_speed,order_speed");
  expect(threshold_columns(), "model,L,branch,l,m,reduced_volume,error,below,above,harmonics");
  expect(mode_columns(), "m,parity,number,eigenvalue,rate,eigenvalue_error,rate_error");
  expect(fluctuation_columns(), "m,parity,number,eigenvalue,mean_square");
  expect(contour_columns(), "m,mean_square,spectrum");
  expect(figures::energy_columns(), "solver,model,reduced_volume,L,triangles,at_rest,time,energy");
  expect(figures::shape_columns(),
         "reduced_volume,L,energy,energy_SSH,order_min,order_max,H_abs_max,order_min_radius,"
         "distance_from_SSH,SSH_distance,triangles,time,ending,energy_3d,order_min_3d,"
         "H_abs_max_3d,distance_3d,frame,lacks_3d");
  expect(figures::cut_columns(), "model,solver,reduced_volume,L,x,z,order");
  expect(figures::evolution_columns(),
         "model,residual_stiffness,instant,time,energy,energy_oblate,energy_oblate_k0_0,"
         "reduced_volume,order_min,order_max,H_abs_max,moment_1,moment_2,moment_3,frame");
  expect(figures::measure_columns(),
         "model,residual_stiffness,unresolved_from,time,energy,W2,order_std,order_variance,"
         "reduced_volume,ended");
  expect(figures::figure_columns(), "figure,command,seconds,result,paper,agreement");
}

}  // namespace
}  // namespace sbeh::studies
