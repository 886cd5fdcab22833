#include "studies/io/columns.h"
#include "studies/modes/modes.h"
#include "studies/report/live_data.h"

namespace sbeh::studies {

Bundle live_modes(const std::filesystem::path& folder, const std::optional<ResultUnits>& units) {
  Bundle bundle;
  add_table(bundle, folder, "modes.csv", units);
  add_units(bundle, units, read_csv(folder / "modes.csv").columns);
  for (const ModeRow& row : read_rows(mode_columns(), folder / "modes.csv")) {
    const std::string name = "modes/" + stem(row.key) + ".csv";
    if (std::filesystem::exists(folder / name)) bundle.add(name, read_file(folder / name));
  }
  return bundle;
}

}  // namespace sbeh::studies
