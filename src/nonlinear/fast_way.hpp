// What a series of solves remembers of the fast way through the contact conditions: part of the state of a run, so
// that a restart takes the same way.
#pragma once

namespace voussoir {

struct FastWay {
  /// solves that go without it: none, 1, 3, 7, ..., twice as many after every failure, so that failures grow as the
  /// logarithm of the solves
  int wait = 0;
  int next_wait = 0;  ///< after its next failure
  int offered = 0;    ///< 1 where it is tried again near the end of the path: it circled
  template <class Archive>
  void keep(Archive& archive) {
    archive.within("fast_way.wait", wait, 0, longest);
    archive.within("fast_way.last_wait", next_wait, 0, longest);
    archive.within("fast_way.offered", offered, 0, 1);
  }
  static constexpr int longest = 1000;  ///< that a wait can be
};

}  // namespace voussoir
