using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Kinematics
{
    public class UrdfHashTests
    {
        const string Text = "<robot name=\"r\">\n<link name=\"a\"/>\n</robot>";

        [Test]
        public void Of_KnownText_ReturnsItsSha256()
        {
            // Computed with sha256sum.
            Assert.That(UrdfHash.Of(Text), Is.EqualTo("3bada97751c435c2819d21ef4703fac782a39cb05b7a5098585f216d490c81be"));
        }

        [TestCase("<robot name=\"r\">\r\n<link name=\"a\"/>\r\n</robot>")]
        [TestCase("<robot name=\"r\">\r<link name=\"a\"/>\r</robot>")]
        [TestCase("\uFEFF<robot name=\"r\">\n<link name=\"a\"/>\n</robot>\n")]
        [TestCase(" \t\r\n<robot name=\"r\">\n<link name=\"a\"/>\n</robot>\r\n\r\n")]
        public void Of_LineEndingsOrOuterWhitespaceChanged_IsEqual(string changed)
        {
            Assert.That(UrdfHash.Of(changed), Is.EqualTo(UrdfHash.Of(Text)));
        }

        [TestCase("<robot name=\"r\">\n<link name=\"b\"/>\n</robot>")]
        [TestCase("<robot name=\"r\">\n\n<link name=\"a\"/>\n</robot>")]
        [TestCase("<robot name=\"r\"> <link name=\"a\"/> </robot>")]
        [TestCase("")]
        public void Of_AnotherText_Differs(string other)
        {
            Assert.That(UrdfHash.Of(other), Is.Not.EqualTo(UrdfHash.Of(Text)));
        }

        [Test]
        public void SourceHash_ModelRead_IsTheHashOfTheText()
        {
            var text = UrdfFiles.Text("youbot.urdf");

            var model = UrdfReader.Read(text.Replace("\r\n", "\n").Replace("\n", "\r\n"), "youbot.urdf");

            Assert.That(model.SourceHash, Is.EqualTo(UrdfHash.Of(text)));
        }
    }
}
