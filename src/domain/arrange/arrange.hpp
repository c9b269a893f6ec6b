#pragma once

#include "domain/domain.hpp"
#include "quadline/context.hpp"
#include "quadline/options.hpp"

namespace quadline {

/// Turns a model into one clean planar arrangement.
///
/// Crossings, touches within the tolerance, overlaps, duplicates and zero-length pieces are resolved here, so that no
/// later stage meets them; lines outside the domain are trimmed. Everything mended is a finding of the result.
///
/// @throws InputError  what cannot be mended: an outer loop without area, a hole outside, a size that is not positive.
/// Cost O((n + k) log n) for n pieces and k meetings.
Domain arrange(const Model& model, const Options& options, Context& context);

}  // namespace quadline
