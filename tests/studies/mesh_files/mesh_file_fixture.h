// Mesh files in a temporary folder, and what is said about them.
#pragma once

#include "studies/io/errors.h"
#include "studies/io/output.h"
#include "studies/mesh_files/mesh_file.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace sbeh::studies::test {

namespace fs = std::filesystem;

class MeshFileTest : public testing::Test {
 protected:
  fs::path path(const std::string& name) const { return folder_.path() / name; }
  fs::path write(const std::string& name, std::string_view text) const {
    write_file(path(name), text);
    return path(name);
  }
  /// What is said about a file, after its name.
  std::string refusal(const std::string& name, std::string_view text) const {
    const fs::path file = write(name, text);
    try {
      read_curved_mesh(file);
    } catch (const InputError& error) {
      const std::string what = error.what();
      EXPECT_TRUE(what.starts_with(file.string())) << what;
      return what.substr(file.string().size());
    }
    return "was not refused";
  }

 private:
  sbeh::test::TemporaryFolder folder_;
};

}  // namespace sbeh::studies::test
