using System.Collections.Generic;

namespace Nowpose.Editor
{
    /// <summary>The triangles of an STL file, in the right-handed axes and the unit of the file (the format does not specify a unit).</summary>
    public sealed class StlTriangles
    {
        readonly List<float> _coordinates = new List<float>();

        /// <summary>Number of triangles that have an area.</summary>
        public int Count => _coordinates.Count / 9;

        /// <summary>Number of triangles that were ignored because their corners coincide or lie on one line.</summary>
        public int Degenerate { get; private set; }

        /// <summary>Nine numbers per triangle: x, y and z of its three corners, which are in anticlockwise order as seen from outside.</summary>
        public IReadOnlyList<float> Coordinates => _coordinates;

        /// <summary>Adds a triangle, or counts it as degenerate.</summary>
        /// <param name="corners">Nine finite numbers: x, y and z of the three corners.</param>
        internal void Add(float[] corners)
        {
            if (HasArea(corners)) _coordinates.AddRange(corners);
            else Degenerate++;
        }

        // Uses double: the precision of float is not sufficient for the products of coordinates in millimetres if the triangle is thin.
        static bool HasArea(float[] c)
        {
            double ax = (double)c[3] - c[0], ay = (double)c[4] - c[1], az = (double)c[5] - c[2];
            double bx = (double)c[6] - c[0], by = (double)c[7] - c[1], bz = (double)c[8] - c[2];
            double x = ay * bz - az * by, y = az * bx - ax * bz, z = ax * by - ay * bx;
            var longest = System.Math.Max(ax * ax + ay * ay + az * az, bx * bx + by * by + bz * bz);
            // A width of less than 1e-7 of the length is within the rounding error of float coordinates, so the area counts as zero.
            return x * x + y * y + z * z > longest * longest * 1e-14;
        }
    }
}
