// Checkpoints. Bytes that begin with one of eight are changes of a good file, three for each: where (two) and what is
// turned over; the seal must refuse such a file. After any other they choose, value by value, what a file holds that is
// sealed in all order: numbers out of range, other types, tables of other sizes. It is refused or restored.
//
// HDF5 1.10 itself does not bear a file whose own tables are forged (a single bit in its tables of names makes it use
// freed memory): that is what the seal is for.
#include <mpi.h>

#include <Teuchos_DefaultSerialComm.hpp>
#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>

#include "dynamics/factor_search.hpp"
#include "dynamics/load_steps.hpp"
#include "dynamics/step_control.hpp"
#include "fuzz.hpp"
#include "nonlinear/fast_way.hpp"
#include "output/checkpoint.hpp"

extern "C" int H5set_free_list_limits(int, int, int, int, int, int);  // of HDF5, whose header one file alone includes
extern "C" __attribute__((weak)) void __lsan_disable();
extern "C" __attribute__((weak)) void __lsan_enable();
extern "C" __attribute__((weak)) void __lsan_do_leak_check();

namespace {

using namespace voussoir;

/// What a run keeps, in small.
struct Run {
  std::vector<StageParameters> stages{2};
  LoadStepParameters parameters;
  LoadSteps steps{stages, parameters};
  FactorSearch search{LoadFactorParameters{}};
  TimeStepLevel level;
  FastWay fast_way;
  LocalRows rows{{0, 1, 2, 3}, 4, 4};
  std::vector<double> displacement = std::vector<double>(8, 0.5);
  std::vector<char> selected = std::vector<char>(4, 1);
  std::string stage = "own weight";

  template <class Archive>
  void keep(Archive& archive) {
    archive.value("stage", stage);
    steps.keep(archive);
    search.keep(archive);
    level.keep(archive);
    fast_way.keep(archive);
    archive.rows("displacement", rows, 2, displacement);
    archive.rows("selected", rows, 1, selected);
  }

  /// Some steps from where it stands: each halved until that is enough, then taken.
  void go_on() {
    StepControl control(level, 1.0, 0.1, 0.01, 0.1, 1e-3, 3);
    for (int step = 0; step < 3; ++step) {
      do {
        steps.set_time_step(control.time_step());
        if (!steps.finished() && steps.target() < steps.reached()) std::abort();
      } while (control.halve());
      control.accept(0, 0.1);
      while (!steps.finished() && steps.halve()) {
      }
      if (!steps.finished()) steps.accept();
      if (search.next()) search.add(Verdict::undecided, fast_way.wait + fast_way.next_wait);
    }
    steps.progress();
    if (displacement.size() != 8 || selected.size() != 4) std::abort();
  }
};

/// Saves under the same names what the bytes say.
class Forger {
 public:
  Forger(Checkpoint& checkpoint, const std::uint8_t* bytes, std::size_t count)
      : checkpoint_(checkpoint), bytes_(bytes), count_(count) {}

  template <class T>
  void value(const std::string& name, T& v) {
    const int what = next();
    long long whole = 256 * next() - 20000;
    double number = what % 8 == 3 ? std::numeric_limits<double>::quiet_NaN() : 1e300 * next();
    std::string text(static_cast<std::size_t>(next()), 'x');
    if (what % 8 == 0) return;  // it is not there
    if (what % 8 == 1) return checkpoint_.value(name, whole);
    if (what % 8 < 4) return checkpoint_.value(name, number);
    if (what % 8 == 4) return checkpoint_.value(name, text);
    checkpoint_.value(name, v);
  }
  template <class T>
  void within(const std::string& name, T& v, double least, double most) {
    T other = static_cast<T>(least + next() - 2);
    value(name, static_cast<double>(other) < most + 3 ? other : v);
  }
  template <class T>
  void rows(const std::string& name, const LocalRows&, int, std::vector<T>&) {
    LocalRows other;
    for (int k = next() % 9; k > 0; --k) other.ids.push_back(other.total++);
    other.owned = other.total;
    const int columns = 1 + next() % 4;
    std::vector<double> numbers(static_cast<std::size_t>(other.total * columns), next() % 5 == 0 ? 1.0 / 0.0 : next());
    if (next() % 2 == 0) return checkpoint_.rows(name, other, columns, numbers);
    std::vector<int> whole(numbers.size(), next());
    checkpoint_.rows(name, other, columns, whole);
  }

 private:
  int next() { return at_ < count_ ? bytes_[at_++] : 7; }

  Checkpoint& checkpoint_;
  const std::uint8_t* bytes_;
  std::size_t count_, at_ = 0;
};

const auto alone = Teuchos::rcp(new Teuchos::SerialComm<int>);
std::string file, good;

/// Whether it could be.
bool restored() {
  bool done = false;
  fuzz::refuse_or_read([&] {
    Checkpoint checkpoint(file, alone, Checkpoint::Way::restore);
    Run run;
    run.keep(checkpoint);
    run.go_on();
    done = true;
  });
  return done;
}

void read_with_changes(const std::uint8_t* bytes, std::size_t count) {
  std::string content = good;
  for (; count >= 3; bytes += 3, count -= 3)
    content[(bytes[0] + 256u * bytes[1]) % content.size()] ^= static_cast<char>(bytes[2]);
  fuzz::write_file(file, content.data(), content.size());
  if (restored() != (content == good)) std::abort();
}

void read_forged(const std::uint8_t* bytes, std::size_t count) {
  Run run;
  Checkpoint checkpoint(file, alone, Checkpoint::Way::save);
  Forger forger(checkpoint, bytes, count);
  run.keep(forger);
  checkpoint.publish();
  restored();
}

}  // namespace

int LLVMFuzzerInitialize(int* argc, char*** argv) {
  if (__lsan_disable) __lsan_disable();  // what MPI keeps until the process ends is no leak of ours
  MPI_Init(argc, argv);
  H5set_free_list_limits(-1, -1, -1, -1, -1, -1);  // an open file takes 0.5 MB: kept, or a third of the time goes there
  file = fuzz::scratch_file(".h5");
  Checkpoint checkpoint(file, alone, Checkpoint::Way::save);
  Run().keep(checkpoint);
  checkpoint.publish();
  std::ifstream saved(file, std::ios::binary);
  good.assign(std::istreambuf_iterator<char>(saved), {});
  restored();
  if (__lsan_enable) __lsan_enable();
  std::atexit([] {
    std::remove(file.c_str());
    if (__lsan_do_leak_check) __lsan_do_leak_check();  // while the libraries of MPI are still there
    MPI_Finalize();
  });
  return 0;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  if (count == 0 || bytes[0] % 8 == 0)
    read_with_changes(bytes + (count > 0), count - (count > 0));
  else
    read_forged(bytes + 1, count - 1);
  return 0;
}
