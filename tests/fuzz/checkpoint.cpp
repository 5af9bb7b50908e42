// Checkpoints. The bytes are changes of a good one, three for each: where (two) and what is turned over. After an even
// number of changes the file keeps its old seal and must be refused; after an odd one it is sealed anew, and whatever
// HDF5 makes of it is refused or restored.
#include <Teuchos_DefaultSerialComm.hpp>
#include <fstream>
#include <iterator>

#include "fuzz.hpp"
#include "dynamics/factor_search.hpp"
#include "dynamics/load_steps.hpp"
#include "output/checkpoint.hpp"
#include "output/safe_file.hpp"

namespace {

using namespace voussoir;

/// What a run keeps, in small.
struct Run {
  std::vector<StageParameters> stages{2};
  LoadStepParameters parameters;
  LoadSteps steps{stages, parameters};
  FactorSearch search{LoadFactorParameters{}};
  LocalRows rows{{0, 1, 2, 3}, 4, 4};
  std::vector<double> displacement = std::vector<double>(8, 0.5);
  std::vector<char> selected = std::vector<char>(4, 1);
  std::string stage = "own weight";

  void keep(Checkpoint& checkpoint) {
    checkpoint.value("stage", stage);
    steps.keep(checkpoint);
    search.keep(checkpoint);
    checkpoint.rows("displacement", rows, 2, displacement);
    checkpoint.rows("selected", rows, 1, selected);
  }
};

const auto alone = Teuchos::rcp(new Teuchos::SerialComm<int>);
std::string file, good;

constexpr std::size_t seal_size = 16;

}  // namespace

int LLVMFuzzerInitialize(int* argc, char*** argv) {
  MPI_Init(argc, argv);
  file = fuzz::scratch_file(".h5");
  Checkpoint checkpoint(file, alone, Checkpoint::Way::save);
  Run().keep(checkpoint);
  checkpoint.publish();
  std::ifstream saved(file, std::ios::binary);
  good.assign(std::istreambuf_iterator<char>(saved), {});
  return 0;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  std::string content = good;
  std::size_t changes = 0;
  for (; 3 * changes + 2 < count; ++changes) {
    const std::size_t place = bytes[3 * changes] + 256u * bytes[3 * changes + 1];
    content[place % content.size()] ^= static_cast<char>(bytes[3 * changes + 2]);
  }
  const bool anew = changes % 2 == 1, changed = content != good;
  if (anew) content.resize(content.size() - seal_size);
  fuzz::write_file(file, content.data(), content.size());
  if (anew) seal_file(file);
  bool restored = false;
  fuzz::refuse_or_read([&] {
    Checkpoint checkpoint(file, alone, Checkpoint::Way::restore);
    Run run;
    run.keep(checkpoint);
    if (!run.steps.finished()) run.steps.progress();
    restored = true;
  });
  if ((restored && changed && !anew) || (!restored && !changed)) std::abort();
  std::remove(file.c_str());
  return 0;
}
