using System;
using Nowpose.Latency.Sweep;

namespace Nowpose.Latency.Load
{
    /// <summary>A load for the GPU: a wall of tiny triangles with as many vertices as asked, in patches that are built one by one.</summary>
    /// <remarks>
    /// A wall one unit wide and <see cref="Height"/> high about the origin, in the plane z = 0, seen from −z, x to the right and y up.
    /// Its patches fill it from the middle outwards, each a part of its own, so that a load grows without what is there being built
    /// anew. No triangle is degenerate. 1 or 2 vertices make no triangle and count as none.
    /// </remarks>
    static class LoadMesh
    {
        /// <summary>Vertices of a full patch: what is handed to the GPU in one go.</summary>
        public const int PatchVertices = LoadPatch.Columns * LoadPatch.Rows;

        /// <summary>Vertices that the greatest load has; the wall has room for no more.</summary>
        public const int GreatestVertices = SweepPlan.GreatestVertices;

        const int PatchColumns = 8, PatchRows = GreatestVertices / PatchVertices / PatchColumns;

        /// <summary>Of the wall, as part of its width.</summary>
        public const float Height = 0.625f;

        const int FewestVertices = 3;

        static readonly int[] FromTheMiddle = SortedByDistance();

        /// <summary>Patches of a load, the last of which need not be full.</summary>
        /// <exception cref="InputException">Fewer than 0 or more than <see cref="GreatestVertices"/>.</exception>
        public static int PatchesOf(int vertices)
        {
            SettingRange.RequireCount(vertices, 0, GreatestVertices, "load, vertices");
            var rest = vertices % PatchVertices;
            return vertices / PatchVertices + (rest >= FewestVertices ? 1 : 0);
        }

        /// <summary>Vertices that are drawn when so many are asked for: the same, but for 1 or 2 beyond full patches.</summary>
        public static int DrawnOf(int vertices) => vertices % PatchVertices < FewestVertices ? vertices - vertices % PatchVertices : vertices;

        /// <param name="patch">0 to <see cref="PatchesOf"/> − 1.</param>
        /// <param name="vertices">Of the whole load.</param>
        public static LoadPatch PatchOf(int patch, int vertices)
        {
            var place = FromTheMiddle[patch];
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
