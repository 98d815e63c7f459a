using System.Collections.Generic;
using System.IO;
using System.Text;
using Nowpose.Editor;
using Nowpose.Editor.Import;
using NUnit.Framework;

namespace Nowpose.Tests.Unity.Import
{
    public class ModelHeaderTests
    {
        [TestCase("<up_axis>X_UP</up_axis>", 0)]
        [TestCase("<up_axis>Y_UP</up_axis>", 1)]
        [TestCase("<up_axis> Z_UP\n</up_axis>", 2)]
        [TestCase("", 1)]
        [TestCase("<up_axis/>", 1)]
        public void UpAxis_Collada_MatchesTheFile(string entry, int axis)
        {
            Assert.That((int)OfText(Collada(entry), ".DAE"), Is.EqualTo(axis));
        }

        [TestCase("not XML")]
        [TestCase("<COLLADA><asset><up_axis>Z_UP</COLLADA>")]
        [TestCase("<!DOCTYPE a [<!ENTITY b 'Z_UP'>]><COLLADA><asset><up_axis>&b;</up_axis></asset></COLLADA>")]
        [TestCase("<COLLADA/>")]
        public void UpAxis_InvalidCollada_IsY(string text)
        {
            Assert.That(OfText(text, ".dae"), Is.EqualTo(UpAxis.Y));
        }

        [Test]
        public void UpAxis_ColladaGeometryWithAsset_UsesTheAssetOfTheDocument()
        {
            Assert.That(OfText(Collada("", "<asset><up_axis>Z_UP</up_axis></asset>"), ".dae"), Is.EqualTo(UpAxis.Y));
        }

        [TestCase("P: \"UpAxis\", \"int\", \"Integer\", \"\",2\n", 2)]
        [TestCase("P: \"OriginalUpAxis\", \"int\", \"Integer\", \"\",0\n\t\tP: \"UpAxis\", \"int\", \"Integer\", \"\",2\r\n", 2)]
        [TestCase("Property: \"UpAxis\", \"int\", \"\",1\n", 1)]
        [TestCase("P: \"UpAxis\", \"int\", \"Integer\", \"\",0\n", 0)]
        [TestCase("P: \"UpAxisSign\", \"int\", \"Integer\", \"\",2\n", 1)]
        [TestCase("P: \"UpAxis\", \"int\", \"Integer\", \"\",up\n", 1)]
        public void UpAxis_TextFbx_MatchesTheFile(string line, int axis)
        {
            Assert.That((int)OfText("; FBX 7.4.0 project file\nGlobalSettings: {\n" + line + "}", ".fbx"), Is.EqualTo(axis));
        }

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(2)]
        public void UpAxis_BinaryFbx_MatchesTheFile(int axis)
        {
            var content = Binary(("OriginalUpAxis", 0), ("UpAxisSign", 2), ("UpAxis", axis), ("FrontAxis", 2));

            Assert.That((int)ModelHeader.UpAxisOf(new MemoryStream(content), ".fbx"), Is.EqualTo(axis));
        }

        [Test]
        public void UpAxis_TruncatedBinaryFbx_IsY()
        {
            var content = Binary(("UpAxis", 2));
            for (var length = 0; length < content.Length; length++)
            {
                var axis = ModelHeader.UpAxisOf(new MemoryStream(content, 0, length), ".fbx");

                Assert.That(axis, Is.EqualTo(UpAxis.Y), length + " bytes");
            }
        }

        [Test]
        public void UpAxis_Obj_IsY()
        {
            Assert.That(OfText("v 0 0 0\n", ".obj"), Is.EqualTo(UpAxis.Y));
        }

        static string Collada(string entry, string geometry = "") =>
            "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\"><asset><contributor/>"
            + "<unit meter=\"0.001\"/>" + entry + "</asset><library_geometries>" + geometry + "</library_geometries></COLLADA>";

        static UpAxis OfText(string text, string extension) =>
            ModelHeader.UpAxisOf(new MemoryStream(Encoding.UTF8.GetBytes(text)), extension);

        static byte[] Binary(params (string Name, int Value)[] properties)
        {
            var bytes = new List<byte>(Encoding.ASCII.GetBytes("Kaydara FBX Binary  \0"));
            foreach (var (name, value) in properties)
            {
                foreach (var text in new[] { name, "int", "Integer", "" })
                {
                    bytes.Add((byte)'S');
                    bytes.AddRange(System.BitConverter.GetBytes(text.Length));
                    bytes.AddRange(Encoding.ASCII.GetBytes(text));
                }
                bytes.Add((byte)'I');
                bytes.AddRange(System.BitConverter.GetBytes(value));
            }
            return bytes.ToArray();
        }
    }
}
