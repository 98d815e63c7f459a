using Nowpose.Cli.Demo;
using Nowpose.Gateway.Plants;
using Nowpose.Motion;
using Nowpose.Simulation;
using Nowpose.Simulation.Work;

namespace Nowpose.Unity.Tests.Demo;

/// <summary>Settings of the demo with its defaults, for runs in virtual time.</summary>
static class VirtualDemo
{
    /// <param name="hasWork">Whether the robot moves workpieces.</param>
    public static DemoSettings Settings(
        double seconds, string network, int seed, string predictor = "adaptive", string name = "youbot", bool hasWork = true)
    {
        var robot = RobotFiles.Load(name, out var urdf);
        var motion = new PickAndPlaceMotion(robot);
        return new DemoSettings
        {
            Seconds = seconds, Network = NetworkProfile.Named(network), Robot = robot, RobotText = urdf,
            Motion = hasWork ? new CellMotion(new CellWork(robot, motion)) : new CellMotion(motion),
            Predictor = predictor, SamplingMs = 50, Acquisition = new(55, 105), VisualisationMs = 40, Seed = seed,
        };
    }
}
