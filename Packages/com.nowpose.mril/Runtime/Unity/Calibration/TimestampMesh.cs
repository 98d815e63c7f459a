using System;
using Nowpose.Latency;
using UnityEngine;

namespace Nowpose.Unity.Calibration
{
    /// <summary>
    /// Draws a timestamp code of 64 squares as a mesh. Only lit squares have triangles, because a see-through display cannot show dark squares.
    /// </summary>
    sealed class TimestampMesh
    {
        const int Corners = 4, IndicesPerCell = 6;

        /// <summary>Corner indices of the two triangles of a square, clockwise as seen in the direction of +z.</summary>
        static readonly int[] Square = { 0, 1, 2, 1, 3, 2 };

        readonly int[] _indices = new int[TimestampCode.CellCount * IndicesPerCell];

        /// <param name="side">Side length of the whole code, in metres. The centre of the code is the origin of the mesh.</param>
        public TimestampMesh(float side)
        {
            var vertices = new Vector3[TimestampCode.CellCount * Corners];
            var normals = new Vector3[vertices.Length];
            for (var i = 0; i < vertices.Length; i++)
            {
                int cell = i / Corners, corner = i % Corners;
                // Order of the corners: lower left, upper left, lower right, upper right.
                float column = cell % TimestampCode.Side + corner / 2, row = cell / TimestampCode.Side + 1 - corner % 2;
                vertices[i] = new Vector3((column / TimestampCode.Side - 0.5f) * side, (0.5f - row / TimestampCode.Side) * side, 0);
                normals[i] = Vector3.back;
            }
            Mesh = new Mesh { name = "Timestamp Code" };
            Mesh.MarkDynamic();
            Mesh.SetVertices(vertices);
            Mesh.SetNormals(normals);
            Mesh.bounds = new Bounds(Vector3.zero, new Vector3(side, side, side / TimestampCode.Side));
        }

        public Mesh Mesh { get; }

        /// <summary>Shows a value as a code. Does not allocate.</summary>
        /// <param name="value">A value returned by <see cref="TimestampCode.ValueOf"/>.</param>
        public void Show(int value)
        {
            Span<bool> cells = stackalloc bool[TimestampCode.CellCount];
            TimestampCode.Draw(value, CodeKind.Headset, cells);
            var count = 0;
            for (var cell = 0; cell < cells.Length; cell++)
                if (cells[cell])
                    foreach (var corner in Square) _indices[count++] = cell * Corners + corner;
            // The bounds already include all squares, lit or not.
            Mesh.SetTriangles(_indices, 0, count, 0, calculateBounds: false);
        }
    }
}
