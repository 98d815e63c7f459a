using Nowpose.Editor;
using Nowpose.Editor.Messages;
using Nowpose.Editor.Setup;
using NUnit.Framework;

namespace Nowpose.Tests.Unity.Setup
{
    public class UnityVersionRatingsTests
    {
        [TestCase("2020.3.48f1", "Missing", "Missing")]
        [TestCase("2021.2.19f1", "Missing", "Missing")]
        [TestCase("2021.3.45f2", "Advice", "Advice")]
        [TestCase("2022.2.1f1", "Advice", "Advice")]
        [TestCase("2022.3.0f1", "Good", "Good")]
        [TestCase("2022.3.62f1", "Good", "Good")]
        [TestCase("2023.2.20f1", "Advice", "Advice")]
        [TestCase("6000.0.78f1", "Advice", "Advice")]
        [TestCase("6000.2.1b3", "Advice", "Advice")]
        [TestCase("6000.3.0f1", "Advice", "Missing")]
        [TestCase("6000.7.0a1", "Advice", "Missing")]
        public void Judge_Version_DependsOnMicrosoftsPlugIn(string version, string without, string with)
        {
            var parsed = UnityVersion.TryParse(version).Value;

            Assert.That(UnityVersionRatings.Judge(parsed, withMicrosoft: false).State.ToString(), Is.EqualTo(without));
            Assert.That(UnityVersionRatings.Judge(parsed, withMicrosoft: true).State.ToString(), Is.EqualTo(with));
            Assert.That(UnityVersionRatings.Judge(parsed, withMicrosoft: true).Found, Does.Contain(version));
        }

        [Test]
        public void Judge_TooNewForThePlugIn_NamesThePlugInAndTheRemedy()
        {
            var found = UnityVersionRatings.Judge(UnityVersion.TryParse("6000.3.2f1").Value, withMicrosoft: true).Found;

            Assert.That(found, Does.Contain(UnityVersionMessages.PlugInFails));
        }

        [TestCase("m_EditorVersion: 2022.3.62f1\r\nm_EditorVersionWithRevision: 2022.3.62f1 (4af31df58517)\r\n", "2022.3.62f1")]
        [TestCase("m_EditorVersion: 6000.0.1f1c1", "6000.0.1f1c1")]
        [TestCase("m_EditorVersion: unknown", null)]
        [TestCase("m_EditorVersion: 2022.3", null)]
        [TestCase("", null)]
        public void InProjectFile_AnyText_ReturnsTheVersionOrNull(string text, string version)
        {
            Assert.That(UnityVersion.InProjectFile(text)?.Text, Is.EqualTo(version));
        }
    }
}
