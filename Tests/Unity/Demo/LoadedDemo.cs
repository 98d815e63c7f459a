using Nowpose.Cli.Demo;
using Nowpose.Cli.Demo.Virtual;
using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Motion;
using Nowpose.Prediction;
using Nowpose.Simulation;

namespace Nowpose.Unity.Tests.Demo;

/// <summary>Runs the demo in virtual time, with or without a rendering load.</summary>
static class LoadedDemo
{
    /// <summary>Runs the demo.</summary>
    /// <param name="vertices">Number of vertices of the load; null for no load.</param>
    /// <param name="profile">Latency profile of the runtime; null for the result of the demo's own calibration.</param>
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
