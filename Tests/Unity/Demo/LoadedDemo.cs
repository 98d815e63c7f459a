using Nowpose.Cli.Demo;
using Nowpose.Cli.Demo.Virtual;
using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Motion;
using Nowpose.Prediction;
using Nowpose.Simulation;

namespace Nowpose.Unity.Tests.Demo;

/// <summary>The main job in virtual time, with or without a load.</summary>
static class LoadedDemo
{
    /// <param name="vertices">Vertices of the load; null for a display without a load.</param>
    /// <param name="profile">The profile given to the runtime; null for the demo's own calibration.</param>
    public static DemoRun Play(int? vertices, int seed, double seconds = 20, LatencyProfile profile = null)
    {
        var robot = RobotFiles.Load("youbot", out var urdf);
        return VirtualStage.Play(new DemoSettings
        {
            Seconds = seconds, Network = NetworkProfile.Wifi, Robot = robot, RobotText = urdf, Motion = new PickAndPlaceMotion(robot),
            Predictor = Predictors.Default, SamplingMs = 50, Acquisition = new(55, 105), VisualisationMs = 40, Load = vertices, Seed = seed,
            Profile = profile,
        }, hasScene: true);
    }
}
