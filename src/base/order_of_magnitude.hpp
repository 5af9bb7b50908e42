// What is clearly more than something else.
#pragma once

namespace voussoir {

/// An order of magnitude. Thresholds that only keep apart what is of one size from what is of another are made of it:
/// nothing finer is known of them, and nothing finer is needed.
inline constexpr double order_of_magnitude = 10;

}  // namespace voussoir
