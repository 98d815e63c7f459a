using Nowpose.Cli.Demo;
using Nowpose.Cli.Demo.Paper;
using Nowpose.Cli.Demo.Virtual;
using Nowpose.Cli.Figures.Swing;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Motion;
using Nowpose.Simulation;

namespace Nowpose.Unity.Tests.Demo.Paper;

/// <summary>The paper's scenario in virtual time, complete, or with one fault.</summary>
static class PaperScene
{
    public const double VisuMs = 40;

    static readonly YoubotSwing Swing = new(isCold: true);

    /// <param name="profileMs">L_visu of the profile.</param>
    /// <param name="clockErrorMs">Error of the clock that the exchanges read.</param>
    /// <param name="stampErrorMs">Maximum error of the samples' stamps.</param>
    public static PaperRun Play(int seed, double profileMs = VisuMs, double clockErrorMs = 0, double stampErrorMs = 0, double seconds = 32)
    {
        var given = new DemoSettings
        {
            Seconds = seconds, Network = NetworkProfile.Wifi, Acquisition = new(55, 105), VisualisationMs = VisuMs, Seed = seed,
            Profile = new LatencyProfile(
                profileMs, 1.2, "simulated headset", 60, DateTime.UnixEpoch, CalibrationMethod.VisibleLight, 120, 15,
                RenderTimeSourceKind.DisplayGpuTime),
        };
        var settings = PaperScenario.Of(given, Swing);
        var sampled = stampErrorMs == 0 ? null : new LateSampling(settings.Motion, stampErrorMs / 1000);
        return new PaperRun(1, VirtualStage.Play(settings, hasScene: true, sampled, TimeSpan.FromMilliseconds(clockErrorMs)), Swing);
    }

    public static IReadOnlyList<PaperClaim> Claims(PaperRun run) => PaperClaims.Of([PaperMeasures.Of(run)]);

    /// <summary>A motion that is sampled at a time other than the stamp states, up to a maximum error in both directions.</summary>
    sealed class LateSampling(IMotion motion, double maxSeconds) : IMotion
    {
        readonly Random _random = new(5);

        public IReadOnlyList<string> JointNames => motion.JointNames;

        public double CycleSeconds => motion.CycleSeconds;

        public void At(double seconds, Span<double> positions) => motion.At(seconds + maxSeconds * (2 * _random.NextDouble() - 1), positions);
    }
}
