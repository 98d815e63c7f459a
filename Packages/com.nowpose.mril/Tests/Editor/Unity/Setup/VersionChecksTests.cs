using Nowpose.Editor;
using Nowpose.Editor.Messages;
using Nowpose.Editor.Setup;
using NUnit.Framework;

namespace Nowpose.Tests.Unity.Setup
{
    public class VersionChecksTests
    {
        const string Core = "org.mixedrealitytoolkit.core", Interaction = "com.unity.xr.interaction.toolkit";

        static string State(ProjectCheck check, IProjectSettings project) => check.Look(project).State.ToString();

        [TestCase("2022.3.62f1", "Good")]
        [TestCase("6000.0.78f1", "Advice")]
        [TestCase("6000.3.2f1", "Missing")]
        [TestCase("2020.3.1f1", "Missing")]
        [TestCase("dev build", "Unknown")]
        public void UnityVersion_ForAHoloLens_IsCheckedWithMicrosoftsPlugIn(string version, string state)
        {
            Assert.That(State(PlayerChecks.EditorVersion, new FakeProject { EditorVersion = version }), Is.EqualTo(state));
        }

        [Test]
        public void UnityVersion_ForAndroid_IsCheckedWithoutMicrosoftsPlugIn()
        {
            var android = new FakeProject(HeadsetPlatform.AndroidHeadset) { EditorVersion = "6000.3.2f1" };

            Assert.That(State(PlayerChecks.EditorVersion, android), Is.EqualTo("Advice"));
        }

        // OpenXR 1.17 has no libraries for Universal Windows Platform and for Android with x86-64.
        [TestCase("1.16.1", false, true, "Good")]
        [TestCase("1.17.0-pre.2", false, true, "Missing")]
        [TestCase("1.17.1", false, true, "Missing")]
        [TestCase("1.17.1", true, false, "Good")]
        [TestCase("1.17.1", true, true, "Missing")]
        [TestCase("1.16.1", true, true, "Good")]
        public void OpenXr_InstalledVersion_IsJudgedForThePlayer(string version, bool isAndroid, bool isX64, string state)
        {
            var project = new FakeProject(isAndroid ? HeadsetPlatform.AndroidHeadset : HeadsetPlatform.HoloLens2) { TargetsX64 = isX64 };
            project.Installed["com.unity.xr.openxr"] = version;

            Assert.That(State(PackageChecks.OpenXr, project), Is.EqualTo(state));
            PackageChecks.OpenXr.Fix(project);
            Assert.That(State(PackageChecks.OpenXr, project), Is.EqualTo("Good"));
        }

        [TestCase(null, null, "Good")]
        [TestCase("3.3.0", "2.6.3", "Good")]
        [TestCase("3.3.0-development", null, "Good")]
        [TestCase("4.0.0-pre.2", "3.0.4", "Missing")]
        [TestCase("4.1.0", "2.6.3", "Missing")]
        [TestCase(null, "3.0.4", "Missing")]
        public void MrtkGeneration_InstalledVersions_DetermineTheState(string mrtk, string interaction, string state)
        {
            var project = new FakeProject();
            if (mrtk != null) project.Installed[Core] = mrtk;
            if (interaction != null) project.Installed[Interaction] = interaction;

            Assert.That(State(PackageChecks.MrtkGeneration, project), Is.EqualTo(state));
        }

        [Test]
        public void MrtkGeneration_TooNew_NamesTheRemedy()
        {
            var project = new FakeProject();
            project.Installed[Core] = "4.0.0-pre.2";
            project.Installed[Interaction] = "3.0.4";

            var found = PackageChecks.MrtkGeneration.Look(project).Found;

            Assert.That(found, Is.EqualTo(CheckResults.NotSupported(
                Core + " 4.0.0-pre.2, " + Interaction + " 3.0.4", 2, Core + " 3.3.0, " + Interaction + " 2.6.3")));
        }

        [Test]
        public void Mrtk3_AllPackagesInstalled_IsGood()
        {
            var project = new FakeProject();
            foreach (var package in ProjectNeeds.Mrtk3) project.Installed[package.Name] = PackageVersion.Read(package.Reference).ToString();

            Assert.That(State(PackageChecks.Mrtk3, project), Is.EqualTo("Good"));
        }

        [TestCase("1.2.3", "1.2.3")]
        [TestCase("1.2.3-pre.4", "1.2.3")]
        [TestCase("https://example.org/x.git?path=/a.b#core-v3.3.0", "3.3.0")]
        [TestCase("https://example.org/x.git#v2.0.4-rc.1", "2.0.4")]
        [TestCase("https://example.org/x.git#releases/2.0.4", "2.0.4")]
        [TestCase("file:a/org.example.core-3.0.1.tgz", "3.0.1")]
        [TestCase("file:a/org.example.core-3.0.1-pre.2.tgz", "3.0.1")]
        [TestCase("https://example.org/x-1.2.3.git", null)]
        [TestCase("https://example.org/x.git#522f0c3f5c2ef7273737707effaa840c65e20e98", null)]
        [TestCase("file:../x", null)]
        [TestCase("99999999999.0.0", null)]
        public void PackageVersion_Reference_IsRead(string reference, string version)
        {
            Assert.That(PackageVersion.Read(reference)?.ToString(), Is.EqualTo(version));
        }
    }
}
