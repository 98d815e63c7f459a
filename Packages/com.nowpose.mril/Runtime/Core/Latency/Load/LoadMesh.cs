using System;
using Nowpose.Latency.Sweep;

namespace Nowpose.Latency.Load
{
    /// <summary>Load for the GPU: a wall of tiny triangles with a given number of vertices, in patches that are built one by one.</summary>
    /// <remarks>
    /// The wall is one unit wide and <see cref="Height"/> high, centred at the origin in the plane z = 0, seen from −z with x to the right
    /// and y up. Separate patches fill it from the middle outwards, so that a growing load keeps its existing patches.
    /// No triangle is degenerate. A remainder of 1 or 2 vertices forms no triangle and is not drawn.
    /// </remarks>
    static class LoadMesh
    {
        /// <summary>Number of vertices of a full patch. Patches are uploaded to the GPU one at a time.</summary>
        public const int PatchVertices = LoadPatch.Columns * LoadPatch.Rows;

        /// <summary>Maximum number of vertices of a load, the capacity of the wall.</summary>
        public const int MaxVertices = SweepPlan.MaxVertices;

        const int PatchColumns = 8, PatchRows = MaxVertices / PatchVertices / PatchColumns;

        /// <summary>Height of the wall divided by its width.</summary>
        public const float Height = 0.625f;

        const int MinPatchVertices = 3;

        static readonly int[] CentreOutwards = SortedByDistance();

        /// <summary>Returns the number of patches of a load. The last patch may be incomplete.</summary>
        /// <exception cref="InputException">The number is below 0 or above <see cref="MaxVertices"/>.</exception>
        public static int PatchesOf(int vertices)
        {
            SettingRange.RequireCount(vertices, 0, MaxVertices, "load, vertices");
            var rest = vertices % PatchVertices;
            return vertices / PatchVertices + (rest >= MinPatchVertices ? 1 : 0);
        }

        /// <summary>Returns how many of the requested vertices are drawn: all except a remainder of 1 or 2 beyond the full patches.</summary>
        public static int DrawnOf(int vertices) => vertices % PatchVertices < MinPatchVertices ? vertices - vertices % PatchVertices : vertices;

        /// <param name="patch">0 to <see cref="PatchesOf"/> − 1.</param>
        /// <param name="vertices">Number of vertices of the whole load.</param>
        public static LoadPatch PatchOf(int patch, int vertices)
        {
            var place = CentreOutwards[patch];
            return new LoadPatch(
                Math.Min(PatchVertices, vertices - patch * PatchVertices),
                (float)(place % PatchColumns) / PatchColumns - 0.5f,
                ((float)(place / PatchColumns) / PatchRows - 0.5f) * Height,
                1f / PatchColumns,
                Height / PatchRows);
        }

        static int[] SortedByDistance()
        {
            var places = new int[PatchColumns * PatchRows];
            var distances = new double[places.Length];
            for (var i = 0; i < places.Length; i++)
            {
                places[i] = i;
                double x = (i % PatchColumns + 0.5) / PatchColumns - 0.5, y = ((i / PatchColumns + 0.5) / PatchRows - 0.5) * Height;
                distances[i] = x * x + y * y;
            }
            Array.Sort(distances, places);
            return places;
        }
    }
}
