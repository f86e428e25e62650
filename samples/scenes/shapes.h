// Meshes that are computed. Normals point outwards and have length 1; triangles go counter-clockwise seen from
// outside; lengths are in the world's units.
#pragma once

#include "samples/files/mesh.h"

namespace boxcar {

// A square in the plane y = 0 round the origin, seen from above (+y). uv go from (0, 0) at (-x, -z), which is at the
// upper left when -z is up, to (uvRepeats, uvRepeats) at (+x, +z).
MeshData Ground(float sideLength, float uvRepeats);

// A cube round the origin, seen from inside: normals point inwards.
MeshData Room(float sideLength);

// The same surface in triangles of a quarter of the area, `times` over; what is flat stays flat.
MeshData Subdivided(MeshData mesh, uint32_t times);

// A sphere round the origin, its poles on the y axis. Seen from outside u goes to the right, once round it from the
// seam at -z, and v down, from 0 at +y to 1 at -y. All vertices lie on the sphere, so the faces are inside it.
//
//   segments  round the axis, at least 3
//   rings     from pole to pole, at least 2; 2 * segments * (rings - 1) triangles
MeshData Sphere(float radius, uint32_t segments, uint32_t rings);

}  // namespace boxcar
