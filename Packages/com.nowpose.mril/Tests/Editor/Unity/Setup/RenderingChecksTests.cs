using Nowpose.Editor;
using Nowpose.Editor.Messages;
using Nowpose.Editor.Setup;
using NUnit.Framework;
using UnityEngine.Rendering;

namespace Nowpose.Tests.Unity.Setup
{
    /// <summary>
    /// Tests the checks of the camera and of the settings that affect the visualisation latency, with correct, wrong, fixed and unknown
    /// values.
    /// </summary>
    public class RenderingChecksTests
    {
        readonly FakeProject _project = new FakeProject();

        static string State(ProjectCheck check, IProjectSettings project) => check.Look(project).State.ToString();

        [TestCase(false, "Good", GraphicsDeviceType.Direct3D11)]
        [TestCase(false, "Missing", GraphicsDeviceType.Direct3D12)]
        [TestCase(false, "Missing", GraphicsDeviceType.Direct3D11, GraphicsDeviceType.Direct3D12)]
        [TestCase(false, "Unknown")]
        [TestCase(true, "Advice", GraphicsDeviceType.Direct3D11)]
        [TestCase(true, "Missing", GraphicsDeviceType.Direct3D12, GraphicsDeviceType.Direct3D11)]
        public void GraphicsApi_List_IsCheckedAndSetToDirect3D11(bool isAutomatic, string state, params GraphicsDeviceType[] apis)
        {
            var project = new FakeProject { IsGraphicsApiAutomatic = isAutomatic, GraphicsApis = apis };
            var check = RenderingChecks.GraphicsApi;
            Assert.That(State(check, project), Is.EqualTo(state));

            Assert.That(check.Fix(project), Is.Null);

            Assert.That(State(check, project), Is.EqualTo("Good"));
            Assert.That(project.GraphicsApis, Is.EqualTo(new[] { GraphicsDeviceType.Direct3D11 }));
        }

        [TestCase(false, "Good")]
        [TestCase(true, "Advice")]
        public void GraphicsJobs_Choice_IsCheckedAndTurnedOff(bool isOn, string state)
        {
            _project.UsesGraphicsJobs = isOn;
            var check = RenderingChecks.GraphicsJobs;
            Assert.That(State(check, _project), Is.EqualTo(state));

            Assert.That(check.Fix(_project), Is.Null);

            Assert.That(State(check, _project), Is.EqualTo("Good"));
        }

        [Test]
        public void GraphicsJobs_OtherTargetActive_AreUnknownAndUnchanged()
        {
            _project.UsesGraphicsJobs = null;
            var check = RenderingChecks.GraphicsJobs;

            Assert.That(State(check, _project), Is.EqualTo("Unknown"));
            Assert.That(check.Fix(_project), Is.EqualTo(CheckFixes.BuildTarget));
            Assert.That(_project.UsesGraphicsJobs, Is.Null);
        }

        [TestCase(0, "Missing")]
        [TestCase(1, "Good")]
        [TestCase(2, "Good")]
        [TestCase(7, "Missing")]
        public void InputHandling_HoloLens_IsCheckedAndSet(int value, string state)
        {
            _project.InputHandling = value;
            var check = PlayerChecks.InputHandling;
            Assert.That(State(check, _project), Is.EqualTo(state));

            Assert.That(check.Fix(_project), Is.Null);

            Assert.That(_project.InputHandling, Is.EqualTo(1));
            Assert.That(State(check, _project), Is.EqualTo("Missing"), "until Unity restarts");
            Assert.That(check.Look(_project).Found, Is.EqualTo(CheckResults.AfterRestart(CheckTitles.InputSystem)));
            _project.IsInputHandlingPending = false;
            Assert.That(State(check, _project), Is.EqualTo("Good"));
        }

        [Test]
        public void InputHandling_BothOnAndroid_IsAdvisedAgainst()
        {
            var android = new FakeProject(HeadsetPlatform.AndroidHeadset) { InputHandling = 2 };

            Assert.That(State(PlayerChecks.InputHandling, android), Is.EqualTo("Advice"));
        }

        [Test]
        public void InputHandling_NotFound_IsUnknownAndFixNamesTheSetting()
        {
            _project.InputHandling = null;
            _project.IsInputHandlingWritable = false;
            var check = PlayerChecks.InputHandling;

            Assert.That(State(check, _project), Is.EqualTo("Unknown"));
            Assert.That(check.Fix(_project), Is.EqualTo(CheckFixes.InputHandling(CheckTitles.InputSystem)));
            Assert.That(_project.SettingsOpened, Is.EqualTo(1));
        }

        [TestCase(null, "Good", "built-in")]
        [TestCase("UniversalRenderPipelineAsset", "Good", "URP")]
        [TestCase("HDRenderPipelineAsset", "Missing", "HDRP")]
        [TestCase("OwnPipelineAsset", "Unknown", "OwnPipelineAsset")]
        public void RenderPipeline_Asset_ReportsPipelineAndShaderSupport(string asset, string state, string words)
        {
            _project.RenderPipeline = asset;
            var check = RenderingChecks.Pipeline;

            Assert.That(State(check, _project), Is.EqualTo(state));
            Assert.That(check.Look(_project).Found, Does.Contain(words).And.Contain("shaders"));
            Assert.That(check.FixLabel, Is.Null);
        }

        [TestCase(true, "Good")]
        [TestCase(false, "Missing")]
        public void Background_MainCamera_IsCheckedAndSetToTransparentBlack(bool isClear, string state)
        {
            _project.ClearsToTransparentBlack = isClear;
            var check = RenderingChecks.CameraBackground;
            Assert.That(State(check, _project), Is.EqualTo(state));

            Assert.That(check.Fix(_project), Is.Null);

            Assert.That(State(check, _project), Is.EqualTo("Good"));
        }

        static readonly object[][] NearClips =
        {
            new object[] { 0.02f, "Missing", CheckResults.NearClip("0.02 m", 1.72, 1.5) },
            new object[] { 0.1f, "Good", "0.1 m" },
            new object[] { 0.3f, "Good", "0.3 m" },
            new object[] { 0.85f, "Advice", CheckResults.FarNearClip("0.85 m") },
        };

        [TestCaseSource(nameof(NearClips))]
        public void NearClip_MainCamera_IsCheckedAgainstTheDepthResolutionAndFixed(float near, string state, string found)
        {
            _project.NearClipMetres = near;
            var check = RenderingChecks.NearClip;
            Assert.That(State(check, _project), Is.EqualTo(state));
            Assert.That(check.Look(_project).Found, Is.EqualTo(found));

            Assert.That(check.Fix(_project), Is.Null);

            Assert.That(_project.NearClipMetres, Is.EqualTo(0.1f));
            Assert.That(State(check, _project), Is.EqualTo("Good"));
        }

        [Test]
        public void Camera_Missing_IsUnknownAndUnchanged()
        {
            foreach (var check in new[] { RenderingChecks.CameraBackground, RenderingChecks.NearClip })
            {
                Assert.That(State(check, _project), Is.EqualTo("Unknown"));
                Assert.That(check.Fix(_project), Does.Contain("Open a scene"));
            }
            Assert.That(_project.NearClipMetres, Is.Null);
            Assert.That(_project.ClearsToTransparentBlack, Is.Null);
        }

        [SetUp]
        public void ResetTheCamera()
        {
            _project.NearClipMetres = null;
            _project.ClearsToTransparentBlack = null;
        }
    }
}
