using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Profile;
using Nowpose.Latency.Sweep;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

public sealed class EarlierProfileTests : CalibrationFolder
{
    static readonly DisplayConditions Vulkan = new(graphicsApi: "Vulkan");

    string Saved(DisplayConditions conditions)
    {
        var path = Path.Combine(Folder, "earlier.json");
        LatencyProfileFile.Save(path, new LatencyProfile(40, 1, conditions, DateTime.UtcNow, CalibrationMethod.VisibleLight, 300, 15,
            RenderTimeSourceKind.DisplayGpuTime, headMotion: new HeadMotionLatency(3, 1)));
        return path;
    }

    static IReadOnlyList<string> WarningsOf(EarlierProfile earlier) =>
        earlier.WithWarnings(new CalibrationPageData("", "", []) { Warnings = ["other"] }).Warnings;

    [Test]
    public void Read_SweepAndOptionsDiffer_WarnsAndUsesTheOptions()
    {
        var earlier = EarlierProfile.Read(null, Vulkan, new DisplayConditions("HoloLens 2", 60, "Direct3D11"));

        Assert.That(WarningsOf(earlier), Is.EqualTo(new[]
        {
            CalibrationMessages.OtherSweep("graphics API", "Direct3D11", "Vulkan"),
            "other",
        }));
        Assert.That(earlier.Conditions, Is.EqualTo(new DisplayConditions("HoloLens 2", 60, "Vulkan")));
    }

    [Test]
    public void Read_SweepWithAnotherGraphicsApi_Warns()
    {
        var path = Saved(new DisplayConditions(graphicsApi: "Direct3D11"));

        var earlier = EarlierProfile.Read(path, DisplayConditions.Unknown, Vulkan);

        Assert.That(WarningsOf(earlier)[0], Is.EqualTo(CalibrationMessages.OtherProfile(path, "graphics API", "Direct3D11", "Vulkan")));
    }

    [Test]
    public void With_NewLVisu_KeepsConditionsLimitAndHeadMotion()
    {
        var earlier = EarlierProfile.Read(Saved(new DisplayConditions("HoloLens 2", renderPipeline: "built-in")), Vulkan);

        var profile = earlier.With(50, 1, CalibrationMethod.Nudge, 3);

        Assert.That(WarningsOf(earlier), Is.EqualTo(new[] { "other" }));
        Assert.That(profile.Conditions, Is.EqualTo(new DisplayConditions("HoloLens 2", null, "Vulkan", null, "built-in")));
        Assert.That(profile.Range.Limit.TotalMilliseconds, Is.EqualTo(15));
        Assert.That(profile.HeadMotion.Latency.TotalMilliseconds, Is.EqualTo(3));
    }

    [Test]
    public void SweepTable_ConditionsInHeaderAndRows_AreCombined()
    {
        var path = Write("sweep.csv", ["# graphics_api: Vulkan", "# reprojection: depth", SweepLog.Header, "5,0,4,display_gpu_time,HoloLens 2,60"]);

        SweepTable.Read(path, out var conditions);

        Assert.That(conditions, Is.EqualTo(new DisplayConditions("HoloLens 2", 60, "Vulkan", reprojection: ReprojectionMode.Depth)));
    }
}
