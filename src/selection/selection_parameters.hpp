// Which contact points are resolved as contact.
#pragma once

namespace voussoir {

class ParameterSection;

enum class SelectionMode { bonded, adaptive, all };

/// As scenes name it.
inline const char* name_of(SelectionMode mode) {
  return mode == SelectionMode::bonded ? "bonded" : mode == SelectionMode::all ? "all" : "adaptive";
}

struct SelectionParameters {
  SelectionMode mode = SelectionMode::adaptive;
  double error_tolerance = 0.01;  ///< [-] wanted relative error in the energy norm; 0 releases every violating point
  double bulk = 0.99;             ///< [-] share of the predicted energy decrease that a round releases, 0 < bulk <= 1
  bool whole_joints = true;       ///< release all points of the joint of a marked point
  double largest_share = 0.5;     ///< [-] share of selected points above which all are selected
  int largest_rounds = 50;
  int rest = 10;  ///< time steps of rest after which a point is bonded again; 0 = never
  void declare(ParameterSection&);
};

}  // namespace voussoir
