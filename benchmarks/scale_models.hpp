#pragma once

#include "quadline/model.hpp"

namespace quadline {

// Models of any size, like those of models/scale.py; `quads` is about the number of quads of their meshes.

/// Stiffened panel: longitudinals crossed by transverse webs, manholes, round openings, short dangling carlings.
Model panel(double quads);

/// Square plate with dangling lines at random angles and round holes.
Model random_lines(double quads);

/// Square plate with nothing in it.
Model plain(double quads);

}  // namespace quadline
