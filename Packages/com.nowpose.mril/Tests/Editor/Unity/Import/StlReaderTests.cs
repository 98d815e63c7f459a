using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Nowpose.Editor;
using Nowpose.Editor.Messages;
using NUnit.Framework;

namespace Nowpose.Tests.Unity.Import
{
    public class StlReaderTests
    {
        static readonly float[] Lower = { 0, 0, 0, 1, 0, 0, 1, 2, 0 };
        static readonly float[] Upper = { 0, 0, 0, 1, 2, 0, 0, 2, 0.5f };

        [Test]
        public void Read_TextFile_ReturnsTheCornersInOrder()
        {
            var triangles = ReadText(Solid(Facet(Lower), Facet(Upper)));

            Assert.That(triangles.Coordinates, Is.EqualTo(Lower.Concat(Upper)));
        }

        [Test]
        public void Read_BinaryFile_ReturnsTheCornersInOrder()
        {
            var triangles = StlReader.Read(Binary("exported", Lower, Upper), "a.stl");

            Assert.That(triangles.Coordinates, Is.EqualTo(Lower.Concat(Upper)));
        }

        [Test]
        public void Read_BinaryStartingWithSolid_IsReadAsBinary()
        {
            var triangles = StlReader.Read(Binary("solid exported by some tool", Lower, Upper), "a.stl");

            Assert.That(triangles.Count, Is.EqualTo(2));
        }

        [Test]
        public void Read_UpperCaseTextWithLeadingSpacesAndWindowsLineEndings_IsReadAsText()
        {
            var text = "\r\n  SOLID one two\r\n\r\n" + Facet(Lower).ToUpperInvariant().Replace("\n", "\r\n") + "ENDSOLID one two\r\n";

            Assert.That(ReadText(text).Coordinates, Is.EqualTo(Lower));
        }

        [Test]
        public void Read_TextWithByteOrderMarkAndNumbersInExponents_IsReadAsText()
        {
            var text = "\uFEFFsolid\n" + Facet("1.5e-3", "-2E+1", "0", "1", "0", "0", "0", "1", "0") + "endsolid\n";

            Assert.That(ReadText(text).Coordinates.Take(2), Is.EqualTo(new[] { 0.0015f, -20f }));
        }

        [Test]
        public void Read_TwoSolids_AreCombinedIntoOneMesh()
        {
            Assert.That(ReadText(Solid(Facet(Lower)) + Solid(Facet(Upper))).Count, Is.EqualTo(2));
        }

        [TestCase(0f, 0f, 0f, 0f, 0f, 0f, 1f, 1f, 1f, TestName = "Read_TwoEqualVertices_SkipsTheTriangle")]
        [TestCase(0f, 0f, 0f, 1f, 1f, 1f, 3f, 3f, 3f, TestName = "Read_CollinearVertices_SkipsTheTriangle")]
        [TestCase(100f, 0f, 0f, 200f, 0f, 0f, 150f, 1e-6f, 0f, TestName = "Read_TriangleThinnerThanRounding_SkipsTheTriangle")]
        public void Read_TriangleWithoutArea_IsOmitted(params float[] corners)
        {
            var triangles = ReadText(Solid(Facet(Lower), Facet(corners)));

            Assert.That(triangles.Count, Is.EqualTo(1));
            Assert.That(triangles.Degenerate, Is.EqualTo(1));
        }

        [Test]
        public void Read_SmallTriangleFarFromTheOrigin_IsKept()
        {
            var corners = new[] { 1000f, 1000f, 1000f, 1000.1f, 1000f, 1000f, 1000f, 1000.1f, 1000f };

            Assert.That(ReadText(Solid(Facet(corners))).Count, Is.EqualTo(1));
        }

        static readonly string[][] InvalidTexts =
        {
            new[] { "", StlMessages.HeaderCut("a.stl", 0, 84) },
            new[] { "soli", StlMessages.HeaderCut("a.stl", 4, 84) },
            new[] { "solid empty\nendsolid\n", "a.stl: " + StlMessages.NoTriangles },
            new[] { "solid a\n", "a.stl:1: " + StlMessages.NoEndSolid },
            new[] { "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "a.stl:4: " + StlMessages.NoEndSolid },
            new[] { "solid a\nfacet\nvertex 0 0\n", "a.stl:3: " + StlMessages.VertexNumbers(2) },
            new[] { "solid a\nfacet\nvertex 0 0 nan\n", "a.stl:3: " + StlMessages.NotANumber("nan") },
            new[] { "solid a\nfacet\nvertex 0 0 1e99\n", "a.stl:3: " + StlMessages.NotANumber("1e99") },
            new[] { "solid a\nfacet\nvertex 0 0 1,5\n", "a.stl:3: " + StlMessages.NotANumber("1,5") },
            new[] { "solid a\nvertex 0 0 0\n", "a.stl:2: " + StlMessages.VertexOutside },
            new[] { "solid a\nfacet\nfacet\n", "a.stl:3: " + StlMessages.FacetOutside },
            new[] { "solid a\nfacet\nendsolid\n", "a.stl:3: " + StlMessages.EndSolid },
            new[] { "solid a\nfacet\nvertex 0 0 0\nvertex 1 0 0\nendfacet\n", "a.stl:5: " + StlMessages.Corners(2) },
            new[] { "solid a\nfacet\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n", "a.stl:6: " + StlMessages.FourthCorner },
            new[] { "solid a\nendfacet\n", "a.stl:2: " + StlMessages.EndFacet },
            new[] { "solid a\nouter loop\n", "a.stl:2: " + StlMessages.EndLoop },
            new[] { "solid a\nsolid b\n", "a.stl:2: " + StlMessages.SolidInSolid },
            new[] { "solid a\n\nbox 1 2 3\n", "a.stl:3: " + StlMessages.NotAKeyword("box") },
        };

        [TestCaseSource(nameof(InvalidTexts))]
        public void Read_InvalidText_ThrowsWithThePosition(string text, string message) => Refuses(Encoding.UTF8.GetBytes(text), message);

        [Test]
        public void Read_OnlyTrianglesWithoutArea_ThrowsWithTheCount() => Refuses(
            Binary("", new float[9], new float[9]), "a.stl: " + StlMessages.NoArea(2));

        [Test]
        public void Read_LongWordWithControlCharacters_IsShownInOneShortLine()
        {
            var error = Assert.Throws<InputException>(() => ReadText("solid a\n\u0001\u0002" + new string('x', 5000) + "\n"));

            Assert.That(error.Message.Length, Is.LessThan(120));
            Assert.That(error.Message.Any(char.IsControl), Is.False);
        }

        [TestCase("exported")]
        [TestCase("solid exported")]
        public void Read_TruncatedBinary_ThrowsWithTheLengths(string header)
        {
            var content = Binary(header, Lower, Upper);

            Refuses(
                content.Take(content.Length - 1).ToArray(),
                StlMessages.OtherLength("a.stl", 80, 2, 184, 183));
        }

        [Test]
        public void Read_BinaryWithTooSmallCount_ThrowsWithBothLengths()
        {
            var content = Binary("exported", Lower, Upper);
            content[80] = 1;

            Refuses(content, StlMessages.OtherLength("a.stl", 80, 1, 134, 184));
        }

        [Test]
        public void Read_BinaryWithHugeCount_IsRefusedWithoutAllocation()
        {
            var content = Binary("exported", Lower);
            content[80] = content[81] = content[82] = content[83] = 0xFF;

            Refuses(content, StlMessages.TooMany("a.stl, byte 80", uint.MaxValue, StlReader.MaxTriangles));
        }

        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        public void Read_BinaryWithInvalidNumber_ThrowsWithByteAndTriangle(float bad)
        {
            var corners = (float[])Upper.Clone();
            corners[4] = bad;

            // The number follows 84 bytes of header, 50 bytes of the first triangle, 12 bytes of the normal, and 16 bytes of four numbers.
            Refuses(Binary("exported", Lower, corners), StlMessages.NotFinite("a.stl", 162, 2));
        }

        [Test]
        public void ReadFile_LargerThanTheLimit_IsRefusedWithoutReading()
        {
            var path = Path.GetTempFileName();
            try
            {
                using (var file = File.OpenWrite(path)) file.SetLength(StlReader.MaxFileBytes + 1);

                var error = Assert.Throws<InputException>(() => StlReader.ReadFile(path, "a.stl"));

                Assert.That(error.Message, Is.EqualTo(StlMessages.FileTooLong("a.stl", StlReader.MaxFileBytes + 1, StlReader.MaxFileBytes)));
            }
            finally
            {
                File.Delete(path);
            }
        }

        static void Refuses(byte[] content, string message)
        {
            var error = Assert.Throws<InputException>(() => StlReader.Read(content, "a.stl"));

            Assert.That(error.Message, Is.EqualTo(message));
        }

        static StlTriangles ReadText(string text) => StlReader.Read(Encoding.UTF8.GetBytes(text), "a.stl");

        static string Solid(params string[] facets) => "solid a\n" + string.Concat(facets) + "endsolid a\n";

        static string Facet(params float[] corners) => Facet(corners.Select(c => c.ToString("R", System.Globalization.CultureInfo.InvariantCulture)).ToArray());

        static string Facet(params string[] c) => "facet normal 0 0 1\nouter loop\n"
            + string.Concat(Enumerable.Range(0, 3).Select(i => "vertex " + string.Join(" ", c.Skip(3 * i).Take(3)) + "\n")) + "endloop\nendfacet\n";

        static byte[] Binary(string header, params float[][] triangles)
        {
            var content = new List<byte>(Encoding.ASCII.GetBytes(header.PadRight(80)));
            content.AddRange(BitConverter.GetBytes(triangles.Length));
            foreach (var corners in triangles)
            {
                content.AddRange(new byte[12]);
                foreach (var number in corners) content.AddRange(BitConverter.GetBytes(number));
                content.AddRange(new byte[2]);
            }
            return content.ToArray();
        }
    }
}
