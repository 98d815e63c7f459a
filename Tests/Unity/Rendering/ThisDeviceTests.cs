using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Unity;
using Nowpose.Unity.Rendering;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Nowpose.Unity.Tests.Rendering;

public sealed class ThisDeviceTests
{
    PlayedCell _cell;

    [SetUp]
    public void SetUp() => _cell = new PlayedCell();

    [TearDown]
    public void TearDown() => _cell.Dispose();

    sealed class SomePipelineAsset : RenderPipelineAsset
    {
    }

    enum Optimization
    {
        PrioritizeRendering,
        PrioritizeInputPolling,
    }

    sealed class SettingsWithProperty
    {
        public static SettingsWithProperty Instance { get; } = new();

        public Optimization latencyOptimization => Optimization.PrioritizeInputPolling;
    }

    // The settings class of OpenXR after managed code stripping, which has removed the property.
    sealed class SettingsWithField
    {
#pragma warning disable CS0414
        readonly Optimization m_latencyOptimization = Optimization.PrioritizeInputPolling;
#pragma warning restore CS0414

        public static SettingsWithField Instance { get; } = new();
    }

    sealed class SettingsWithoutNativeLibrary
    {
        public static SettingsWithoutNativeLibrary Instance { get; } = new();

        public Optimization latencyOptimization => throw new DllNotFoundException("UnityOpenXR");
    }

    // The settings class of OpenXR before version 1.15, which did not have the setting.
    sealed class SettingsWithout
    {
        public static SettingsWithout Instance { get; } = new();
    }

    [Test]
    public void Conditions_NoDisplayAndNoOpenXr_AreUnknown()
    {
        Assert.That(ThisDevice.Conditions, Is.EqualTo(
            new DisplayConditions("Stand-in", null, "Direct3D11", "MultiThreaded", "built-in")));
    }

    [Test]
    public void Conditions_OtherPlayerSettings_AreRead()
    {
        var gpu = _cell.Player.World.Gpu;
        gpu.ConnectDisplay();
        gpu.DisplayHz = 72;
        gpu.Api = GraphicsDeviceType.Vulkan;
        gpu.Threading = RenderingThreadingMode.NativeGraphicsJobs;
        gpu.RenderPipeline = ScriptableObject.CreateInstance<SomePipelineAsset>();

        Assert.That(ThisDevice.Conditions, Is.EqualTo(new DisplayConditions("Stand-in", 72, "Vulkan", "NativeGraphicsJobs", "SomePipelineAsset")));
    }

    [Test]
    public void OneLine_InvalidName_BecomesValid()
    {
        var name = ThisDevice.OneLine("PC\n" + new string('x', 200));

        Assert.That(new DisplayConditions(name).Device, Does.StartWith("PC x").And.EndsWith("x"));
        Assert.That(name.Length, Is.InRange(100, DisplayConditions.MaxTextLength));
    }

    [TestCase(typeof(SettingsWithProperty), "PrioritizeInputPolling")]
    [TestCase(typeof(SettingsWithField), "PrioritizeInputPolling")]
    [TestCase(typeof(SettingsWithout), null)]
    [TestCase(typeof(SettingsWithoutNativeLibrary), null)]
    [TestCase(null, null)]
    public void LatencyOptimizationOf_SettingsOfAnyVersion_IsReadOrUnknown(Type settings, string expected)
    {
        Assert.That(OpenXrRenderSettings.LatencyOptimizationOf(settings), Is.EqualTo(expected));
    }
}
