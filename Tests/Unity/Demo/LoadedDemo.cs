using Nowpose.Cli.Demo;
using Nowpose.Cli.Demo.Virtual;
using Nowpose.Latency;
using Nowpose.Prediction;

namespace Nowpose.Unity.Tests.Demo;

/// <summary>Runs the demo in virtual time, with or without a rendering load.</summary>
static class LoadedDemo
{
    /// <summary>Runs the demo.</summary>
    /// <param name="vertices">Number of vertices of the load; null for no load.</param>
    /// <param name="profile">Latency profile of the runtime; null for the result of the demo's own calibration.</param>
    public static DemoRun Play(int? vertices, int seed, double seconds = 20, LatencyProfile profile = null) => VirtualStage.Play(
        VirtualDemo.Settings(seconds, "wifi", seed, Predictors.Default, hasWork: false) with { Load = vertices, Profile = profile }, hasScene: true);
}
