using System;
using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Unity;
using UnityEngine;
using UnityEngine.Rendering;

namespace Nowpose.Editor.Import
{
    /// <summary>Builds a Unity mesh from the triangles of an STL, in Unity's axes and with flat shading.</summary>
    /// <remarks>
    /// In an STL, each triangle has its own corners. Corners at the same position become one vertex if their triangles have the same normal. The
    /// edges between faces with different normals therefore stay sharp.
    /// </remarks>
    sealed class StlMesh
    {
        // Maximum number of vertices of a mesh with 16-bit indices.
        const int MaxVerticesWith16Bits = 65535;

        // Number of steps per unit to which the components of a normal are rounded. Rounding is needed because the normals of triangles in one plane
        // differ by up to about 0.05°.
        const float DirectionSteps = 1000;

        readonly Dictionary<(Vector3, Vector3), int> _known = new Dictionary<(Vector3, Vector3), int>();
        readonly List<Vector3> _vertices = new List<Vector3>();
        readonly List<Vector3> _normals = new List<Vector3>();
        readonly List<int> _indices = new List<int>();

        public static Mesh Build(StlTriangles triangles, string name)
        {
            var builder = new StlMesh();
            for (var i = 0; i < triangles.Count; i++) builder.Add(triangles.Coordinates, 9 * i);
            var mesh = new Mesh { name = name };
            if (builder._vertices.Count > MaxVerticesWith16Bits) mesh.indexFormat = IndexFormat.UInt32;
            mesh.SetVertices(builder._vertices);
            mesh.SetNormals(builder._normals);
            mesh.SetTriangles(builder._indices, 0);
            return mesh;
        }

        // Reverses the order of the corners, because the conversion of the axes mirrors the mesh and would turn it inside out.
        void Add(IReadOnlyList<float> coordinates, int at)
        {
            Vector3 a = Corner(coordinates, at), b = Corner(coordinates, at + 6), c = Corner(coordinates, at + 3);
            var normal = Normal(a, b, c);
            var direction = new Vector3(Step(normal.x), Step(normal.y), Step(normal.z));
            foreach (var corner in new[] { a, b, c }) _indices.Add(Vertex(corner, normal, direction));
        }

        int Vertex(Vector3 place, Vector3 normal, Vector3 direction)
        {
            if (_known.TryGetValue((place, direction), out var index)) return index;
            _known.Add((place, direction), index = _vertices.Count);
            _vertices.Add(place);
            _normals.Add(normal);
            return index;
        }

        static Vector3 Corner(IReadOnlyList<float> coordinates, int at) =>
            UnityFrame.DirectionToUnity((coordinates[at], coordinates[at + 1], coordinates[at + 2])).Vector();

        // Uses double, because Vector3.Normalize returns zero for the cross product of edges of one millimetre.
        static Vector3 Normal(Vector3 a, Vector3 b, Vector3 c)
        {
            double px = (double)b.x - a.x, py = (double)b.y - a.y, pz = (double)b.z - a.z;
            double qx = (double)c.x - a.x, qy = (double)c.y - a.y, qz = (double)c.z - a.z;
            double x = py * qz - pz * qy, y = pz * qx - px * qz, z = px * qy - py * qx;
            var length = Math.Sqrt(x * x + y * y + z * z);
            return new Vector3((float)(x / length), (float)(y / length), (float)(z / length));
        }

        static float Step(float part) => Mathf.Round(part * DirectionSteps);
    }
}
