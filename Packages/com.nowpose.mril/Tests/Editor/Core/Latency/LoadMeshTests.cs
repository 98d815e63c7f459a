using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Latency;
using Nowpose.Latency.Load;
using Nowpose.Messages;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency
{
    public class LoadMeshTests
    {
        static IEnumerable<LoadPatch> PatchesOf(int vertices) =>
            Enumerable.Range(0, LoadMesh.PatchesOf(vertices)).Select(patch => LoadMesh.PatchOf(patch, vertices));

        static int[] TrianglesOf(LoadPatch patch)
        {
            var indices = Enumerable.Repeat(-1, patch.Indices).ToArray();
            for (var vertex = 0; vertex < patch.Vertices; vertex++) patch.WriteTriangles(vertex, indices);
            return indices;
        }

        [TestCase(0)]
        [TestCase(3)]
        [TestCase(499)]
        [TestCase(25_000)]
        [TestCase(25_003)]
        [TestCase(300_000)]
        [TestCase(1_234_567)]
        [TestCase(2_000_000)]
        public void Vertices_AllowedCount_DrawsExactlyThatMany(int vertices)
        {
            Assert.That(PatchesOf(vertices).Sum(patch => patch.Vertices), Is.EqualTo(vertices));
            Assert.That(LoadMesh.DrawnOf(vertices), Is.EqualTo(vertices));
        }

        [TestCase(1, 0)]
        [TestCase(2, 0)]
        [TestCase(50_002, 50_000)]
        public void Vertices_TooFewForATriangle_AreNotDrawn(int vertices, int drawn)
        {
            Assert.That(PatchesOf(vertices).Sum(patch => patch.Vertices), Is.EqualTo(drawn));
            Assert.That(LoadMesh.DrawnOf(vertices), Is.EqualTo(drawn));
        }

        [TestCase(-1)]
        [TestCase(2_000_001)]
        public void Vertices_OutOfRange_ThrowsWithTheAllowedRange(int vertices)
        {
            Assert.That(
                () => LoadMesh.PatchesOf(vertices),
                Throws.TypeOf<InputException>().With.Message.EqualTo(SettingMessages.OutOfRange("load, vertices", vertices, "", 0, 2_000_000)));
        }

        [Test]
        public void Triangles_AnyPatch_UseEveryVertexAndFaceTheViewer()
        {
            foreach (var vertices in Enumerable.Range(3, 40).Concat(new[] { 249, 250, 251, 499, 500, 501, 502, 750, 751, 10_001, 24_999, 25_000 }))
            {
                var patch = LoadMesh.PatchOf(0, vertices);

                var indices = TrianglesOf(patch);

                Assert.That(indices.Distinct().OrderBy(i => i), Is.EqualTo(Enumerable.Range(0, vertices)), vertices + " vertices");
                for (var i = 0; i < indices.Length; i += 3)
                    Assert.That(ClockwiseArea(patch, indices, i), Is.GreaterThan(1e-8), "triangle " + i / 3 + " of " + vertices + " vertices");
            }
        }

        // Returns the area of a triangle. It is positive if the vertices are clockwise when seen from −z, with x to the right and y up.
        static double ClockwiseArea(LoadPatch patch, int[] indices, int at)
        {
            patch.PlaceOf(indices[at], out var ax, out var ay);
            patch.PlaceOf(indices[at + 1], out var bx, out var by);
            patch.PlaceOf(indices[at + 2], out var cx, out var cy);
            return -((bx - ax) * (cy - ay) - (cx - ax) * (by - ay)) / 2;
        }

        [Test]
        public void Patches_MaximumLoad_FillTheWallWithoutOverlap()
        {
            var area = 0.0;
            var corners = new HashSet<(float, float)>();
            foreach (var patch in PatchesOf(LoadMesh.MaxVertices))
            {
                patch.PlaceOf(0, out var left, out var bottom);
                patch.PlaceOf(patch.Vertices - 1, out var right, out var top);
                area += (right - left) * (top - bottom);
                corners.Add((left, bottom));
                Assert.That(Math.Max(Math.Abs(left), Math.Abs(right)), Is.LessThan(0.50001));
                Assert.That(Math.Max(Math.Abs(bottom), Math.Abs(top)), Is.LessThan(LoadMesh.Height / 2 + 1e-5));
            }

            Assert.That(area, Is.EqualTo(LoadMesh.Height).Within(1e-4));
            Assert.That(corners, Has.Count.EqualTo(LoadMesh.MaxVertices / LoadMesh.PatchVertices));
        }

        [Test]
        public void Patches_SmallLoad_AreInTheMiddle()
        {
            foreach (var patch in PatchesOf(100_000))
            {
                patch.PlaceOf(patch.Vertices / 2, out var x, out var y);

                Assert.That(Math.Max(Math.Abs(x), Math.Abs(y)), Is.LessThan(0.2));
            }
        }
    }
}
