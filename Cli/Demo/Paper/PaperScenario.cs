using Nowpose.Cli.Calibrate.Simulate;
using Nowpose.Cli.Figures.Swing;
using Nowpose.Gateway.Plants;
using Nowpose.Simulation.Work;
using Nowpose.Sync;

namespace Nowpose.Cli.Demo.Paper;

/// <summary>Defines the conditions of Sect. 3 of the paper as settings of the demo.</summary>
static class PaperScenario
{
    public const string Predictor = "quadratic", Robot = "youbot", Estimator = ClockEstimators.Ransac;

    public const double SamplingMs = 50;

    /// <summary>Default and minimum duration of a run, s. The clock settles for 10 s, and a swing takes about 5 s.</summary>
    public const double Seconds = 40, MinSeconds = 20;

    /// <summary>Number of vertices at the normal load of the paper's Fig. 10a.</summary>
    const int Vertices = 300_000;

    /// <param name="given">Settings whose network, acquisition, display latency, duration and seed are kept. The scenario sets the others.</param>
    public static DemoSettings Of(DemoSettings given, YoubotSwing swing)
    {
        RobotFiles.Load(Robot, out var urdf);
        return given with
        {
            Robot = swing.Robot,
            RobotText = urdf,
            Motion = new CellMotion(new SwingMotion(swing)),
            MotionName = DemoTexts.PaperSwing,
            Predictor = Predictor,
            // In the paper, a new section replaces the previous one without a blend.
            BlendMs = 0,
            Estimator = Estimator,
            SamplingMs = SamplingMs,
            SteadyVertices = Vertices,
            RefreshMs = SimulatedSweep.RefreshMs,
            HasConstantSyncInterval = true,
        };
    }
}
