#pragma once

#include <vector>

#include "domain/size/size_field.hpp"
#include "mesh/work_mesh.hpp"

namespace quadline {

/// Faces that are not sound quads, in the order of their ids.
std::vector<FaceId> unsound_faces(const WorkMesh& mesh);

/// The middle of the corners.
Point centre_of(const WorkMesh& mesh, FaceId f);

/// Freezes the sound quads that clean-up and untangling would take for tangled ones and spoil: very thin ones, and
/// those with a wide corner at a node that stays.
void freeze_thin_quads(WorkMesh& mesh);

/// Freezes the sound quads near places, up to `reach` sizes from them.
void freeze_near(WorkMesh& mesh, const std::vector<Point>& places, double reach, const SizeField& size);

}  // namespace quadline
