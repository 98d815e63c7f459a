using Nowpose.Cli.Calibrate.Simulate;
using Nowpose.Cli.Figures.Swing;
using Nowpose.Cli.Messages;
using Nowpose.Gateway.Plants;
using Nowpose.Sync;

namespace Nowpose.Cli.Demo.Paper;

/// <summary>The paper's Sect. 3 as settings of the demo.</summary>
static class PaperScenario
{
    public const string Predictor = "quadratic", Robot = "youbot", Estimator = ClockEstimators.Ransac;

    public const double SamplingMs = 50;

    /// <summary>Length of a run, s: by default, and at least. The clock settles for 10 s; a swing takes about 5 s.</summary>
    public const double Seconds = 40, MinSeconds = 20;

    /// <summary>The ordinary load of the paper's Fig. 10a.</summary>
    const int Vertices = 300_000;

    /// <param name="given">Settings of network, acquisition, display latency, length and seed.</param>
    public static DemoSettings Of(DemoSettings given, YoubotSwing swing)
    {
        RobotFiles.Load(Robot, out var urdf);
        return given with
        {
            Robot = swing.Robot,
            RobotText = urdf,
            Motion = new SwingMotion(swing),
            MotionName = DemoTexts.PaperSwing,
            Predictor = Predictor,
            // In the paper, a new section replaces the previous one immediately.
            BlendMs = 0,
            Estimator = Estimator,
            SamplingMs = SamplingMs,
            SteadyVertices = Vertices,
            RefreshMs = SimulatedSweep.RefreshMs,
            HasConstantSyncInterval = true,
        };
    }
}
