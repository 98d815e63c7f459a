using Nowpose.Cli.Demo;
using Nowpose.Latency;
using Nowpose.Latency.Profile;

namespace Nowpose.Headless.Tests.Cli.Figures;

/// <summary>Creates latency profiles for the simulated display of the swing study, whose true L_visu is 40 ms.</summary>
static class SwingProfile
{
    public static LatencyProfile Of(double visuMs) => new(
        visuMs, 1.2, "simulated headset", DemoDisplay.FramesPerSecond, DateTime.UnixEpoch, CalibrationMethod.VisibleLight, 120, 15,
        RenderTimeSourceKind.DisplayGpuTime);
}
