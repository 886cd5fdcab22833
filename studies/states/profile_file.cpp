#include "studies/states/profile_file.h"

#include "axisym/curvature.h"

#include <sstream>

namespace sbeh::studies {

// By quadrature up to each of them.
axisym::Field arc_lengths(const axisym::Nodes& X) {
  axisym::Field s = axisym::Field::Zero(X.cols());
  for (int e = 0; e < axisym::element_count(X); ++e)
    for (int a = 1; a <= 3; ++a) {
      double length = 0;
      for (const axisym::ShapeValues& q : axisym::diagnostic_points())
        length += a / 3. * q.weight
                * axisym::curve_point(X, e, axisym::shape_values(a / 3. * q.x)).stretch;
      s[3 * e + a] = s[3 * e] + length;
    }
  return s;
}

const Columns<ProfileRow>& profile_columns() {
  static const Columns<ProfileRow> columns{
      column("arc_length", &ProfileRow::arc_length),
      column("r", &ProfileRow::r),
      column("z", &ProfileRow::z),
      column("order", &ProfileRow::order),
      column("mean_curvature", &ProfileRow::mean_curvature),
  };
  return columns;
}

void write_profile(const std::filesystem::path& path, const axisym::State& state) {
  const axisym::Field s = arc_lengths(state.X), H = axisym::mean_curvature(state.X);
  std::vector<ProfileRow> rows;
  for (Eigen::Index i = 0; i < state.beta.size(); ++i)
    rows.push_back({s[i], state.X(0, i), state.X(1, i), state.beta[i], H.size() ? H[i] : 0});
  write_file(path, table_text(profile_columns(), rows));
}

axisym::State read_profile(const std::filesystem::path& path, std::string_view advice) {
  const auto fail = [&](std::string_view what) {
    throw OutputError(fmt::format("{}: {}: {}", path.string(), what, advice));
  };
  std::istringstream text(read_file(path));
  std::string line;
  if (!std::getline(text, line) || line != header_of(profile_columns()))
    fail("is no profile of this program");
  std::vector<ProfileRow> nodes;
  while (std::getline(text, line)) {
    const auto node = row_of(profile_columns(), split_csv(line));
    if (!node) fail(fmt::format("line {} is damaged", nodes.size() + 2));
    nodes.push_back(*node);
  }
  if (nodes.size() < 4 || nodes.size() % 3 != 1) fail("is cut off");
  axisym::State state{axisym::Nodes(2, Eigen::Index(nodes.size())),
                      axisym::Field(Eigen::Index(nodes.size()))};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    state.X.col(Eigen::Index(i)) << nodes[i].r, nodes[i].z;
    state.beta[Eigen::Index(i)] = nodes[i].order;
  }
  return state;
}

}  // namespace sbeh::studies
