using System;

namespace Nowpose.Latency.Load
{
    /// <summary>One part of a <see cref="LoadMesh"/>: a rectangular grid whose last row may be incomplete.</summary>
    /// <remarks>
    /// Vertices are ordered in rows, starting at the lower left. The triangles of a vertex depend only on its index, so that any number of
    /// vertices can be built at a time.
    /// </remarks>
    readonly struct LoadPatch
    {
        /// <summary>Number of vertices in a row, and number of rows, of a full patch.</summary>
        public const int Columns = 250, Rows = 100;

        const int IndicesPerCell = 6;

        readonly int _columns;
        readonly float _left, _bottom, _stepX, _stepY;

        /// <param name="vertices">3 to <see cref="Columns"/> × <see cref="Rows"/>.</param>
        internal LoadPatch(int vertices, float left, float bottom, float width, float height)
        {
            Vertices = vertices;
            // A patch with fewer than two full rows has shorter rows, because a single row has no triangles.
            _columns = Math.Max(2, Math.Min(Columns, vertices / 2));
            _left = left;
            _bottom = bottom;
            _stepX = width / (Columns - 1);
            _stepY = height / (Rows - 1);
        }

        public int Vertices { get; }

        /// <summary>Number of triangle indices, three for each triangle.</summary>
        public int Indices
        {
            get
            {
                int rest = Vertices % _columns, cells = (Vertices / _columns - 1) * (_columns - 1);
                return rest == 1 ? cells * IndicesPerCell + IndicesPerCell / 2 : (cells + Math.Max(0, rest - 1)) * IndicesPerCell;
            }
        }

        /// <summary>Computes the position of a vertex, in units of the wall's width.</summary>
        /// <param name="vertex">0 to <see cref="Vertices"/> − 1.</param>
        public void PlaceOf(int vertex, out float x, out float y)
        {
            x = _left + vertex % _columns * _stepX;
            y = _bottom + vertex / _columns * _stepY;
        }

        /// <summary>
        /// Writes the triangles whose last vertex is the given vertex into the index array. The winding is clockwise when seen along +z.
        /// </summary>
        /// <param name="indices">Indices of the whole patch, length <see cref="Indices"/> or more.</param>
        public void WriteTriangles(int vertex, int[] indices)
        {
            int column = vertex % _columns, row = vertex / _columns;
            if (row == 0) return;
            int below = vertex - _columns, at = ((row - 1) * (_columns - 1) + column - 1) * IndicesPerCell;
            if (column > 0)
            {
                Write(indices, at, below - 1, vertex - 1, vertex);
                Write(indices, at + IndicesPerCell / 2, below - 1, vertex, below);
            }
            // A single vertex in the last row would otherwise belong to no triangle.
            else if (vertex == Vertices - 1) Write(indices, at + IndicesPerCell, below, vertex, below + 1);
        }

        static void Write(int[] indices, int at, int a, int b, int c)
        {
            indices[at] = a;
            indices[at + 1] = b;
            indices[at + 2] = c;
        }
    }
}
