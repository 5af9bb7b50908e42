// What a series of solves remembers of the fast way through the contact conditions: part of the state of a run, so
// that a restart takes the same way.
#pragma once

namespace voussoir {

struct FastWay {
  int wait = 0;       ///< solves that go without it: none, 1, 3, up to a bound that is a setting
  int next_wait = 0;  ///< after its next failure
  int offered = 0;    ///< 1 where it is tried again near the end of the path: it circled
  template <class Archive>
  void keep(Archive& archive) {
    archive.within("fast_way.wait", wait, 0, longest);
    archive.within("fast_way.last_wait", next_wait, 0, longest);
    archive.within("fast_way.offered", offered, 0, 1);
  }
  static constexpr int longest = 1000;  ///< that a wait can be, whatever the settings of the run are
};

}  // namespace voussoir
