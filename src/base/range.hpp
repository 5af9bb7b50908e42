// The values a number of a scene may have.
#pragma once

#include <string>

namespace voussoir {

/// An interval of finite numbers, with or without its ends; infinity only where or_infinite() says so; never NaN.
class Range {
 public:
  bool contains(double) const;
  /// In words: ">= 0", "> -1 and < 0.5", ">= 2 and even", ">= 0 or inf"; "finite" when any finite number will do.
  std::string text() const;

  Range or_infinite() const;
  Range even() const;
  /// Sizes that are usual: another is allowed, and a warning asks whether its unit is meant. Signs do not matter, and
  /// nothing at all (0) and infinity are usual wherever they are allowed.
  Range usually(double least, double most) const;
  bool is_usual(double) const;
  /// "0.05 to 2", or "" where nothing is unusual.
  std::string usual_text() const;

 private:
  friend Range any_number();
  friend Range at_least(double);
  friend Range above(double);
  friend Range between(double, double);
  friend Range above_up_to(double, double);
  friend Range from_below(double, double);
  friend Range inside(double, double);
  Range(double low, bool with_low, double high, bool with_high);

  double low_, high_;
  double least_usual_ = 0, most_usual_ = 0;  ///< both 0: nothing is unusual
  bool with_low_, with_high_;
  bool infinite_ = false, even_ = false;
};

Range any_number();
Range at_least(double low);                  ///< [low, inf)
Range above(double low);                     ///< (low, inf)
Range between(double low, double high);      ///< [low, high]
Range above_up_to(double low, double high);  ///< (low, high]
Range from_below(double low, double high);   ///< [low, high)
Range inside(double low, double high);       ///< (low, high)

}  // namespace voussoir
