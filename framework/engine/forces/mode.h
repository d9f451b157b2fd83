#pragma once

namespace muelle::engine::mode {

/// What an internal variable says about a force that can be on or off.
inline constexpr double live = 0.0;    ///< as positions and velocities say
inline constexpr double open = 1.0;    ///< off until the next commit or event, whatever they say
inline constexpr double closed = 2.0;  ///< on until then

}  // namespace muelle::engine::mode
