#include "studies/io/columns.h"

namespace sbeh::studies {

bool read_field(int& value, const std::string& field) {
  double number = 0;
  if (!parse_number(field, number)) return false;
  value = int(number);
  return true;
}

bool read_field(bool& value, const std::string& field) {
  value = field == "1";
  return value || field == "0";
}

}  // namespace sbeh::studies
