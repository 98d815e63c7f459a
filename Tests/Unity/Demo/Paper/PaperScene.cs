using System.Collections.Concurrent;
using System.Globalization;
using Nowpose.Cli.Demo;
using Nowpose.Cli.Demo.Paper;
using Nowpose.Cli.Demo.Virtual;
using Nowpose.Cli.Figures.Swing;
using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Motion;
using Nowpose.Simulation;
using Nowpose.Simulation.Work;

namespace Nowpose.Unity.Tests.Demo.Paper;

/// <summary>Runs the paper's scenario in virtual time, correctly or with one fault.</summary>
static class PaperScene
{
    public const double VisuMs = 40;

    static readonly YoubotSwing Swing = new(isCold: true);

    /// <summary>Creates a profile with a given L_visu in ms.</summary>
    public static LatencyProfile ProfileOf(double visuMs) => new(
        visuMs, 1.2, "simulated headset", 60, DateTime.UnixEpoch, CalibrationMethod.VisibleLight, 120, 15, RenderTimeSourceKind.DisplayGpuTime);

    /// <summary>
    /// Gets the profile that <c>demo --paper</c> measures with a seed. Reference data of <c>dotnet run -c Release --project Benchmarks -- paper</c>: reading
    /// the rendered pictures of ten seeds takes minutes of processor time.
    /// </summary>
    public static LatencyProfile MeasuredProfile(int seed)
    {
        var fields = RepositoryFiles.Read("Tests/Unity/Demo/Paper/calibrations.csv").Split('\n', StringSplitOptions.RemoveEmptyEntries).Skip(1)
            .Select(line => line.Split(',')).Single(each => each[0] == $"{seed}");
        double Number(int field) => double.Parse(fields[field], CultureInfo.InvariantCulture);
        return new(
            Number(1), Number(2), "simulated headset", 60, DateTime.UnixEpoch, CalibrationMethod.VisibleLight, (int)Number(3), Number(4),
            RenderTimeSourceKind.DisplayGpuTime);
    }

    static readonly ConcurrentDictionary<int, PaperRun> Played = new();

    /// <summary>Returns the run with a seed and without a fault. Several tests read it, so it is played only once.</summary>
    public static PaperRun Play(int seed) => Played.GetOrAdd(seed, _ => Play(seed, ProfileOf(VisuMs)));

    /// <summary>Runs the scenario.</summary>
    /// <param name="profile">Latency profile of the runtime; null for a profile with the true L_visu.</param>
    /// <param name="clockErrorMs">Error, in ms, of the clock that the exchanges read.</param>
    /// <param name="stampErrorMs">Maximum error of the samples' stamps in ms.</param>
    public static PaperRun Play(int seed, LatencyProfile profile = null, double clockErrorMs = 0, double stampErrorMs = 0, double seconds = 32,
        NetworkProfile network = null)
    {
        var given = Given(seed) with { Seconds = seconds, Profile = profile ?? ProfileOf(VisuMs), Network = network ?? NetworkProfile.Wifi };
        var settings = PaperScenario.Of(given, Swing);
        var sampled = stampErrorMs == 0 ? null : new LateSampling(settings.Motion.Motions[0].Motion, stampErrorMs / 1000);
        return new PaperRun(1, VirtualStage.Play(settings, hasScene: true, sampled, TimeSpan.FromMilliseconds(clockErrorMs)), Swing);
    }

    /// <summary>Creates the settings that <c>demo</c> has without <c>--paper</c>: the robot picks and places workpieces.</summary>
    public static DemoSettings Given(int seed)
    {
        var robot = RobotFiles.Load("youbot");
        return new()
        {
            Network = NetworkProfile.Wifi, Acquisition = new(55, 105), VisualisationMs = VisuMs, Seed = seed,
            Robot = robot, Motion = new CellMotion(new CellWork(robot, new PickAndPlaceMotion(robot))),
        };
    }

    public static IReadOnlyList<PaperClaim> Claims(PaperRun run) => PaperClaims.Of([PaperMeasures.Of(run)]);

    /// <summary>Simulates time stamp errors: samples the motion earlier or later than the stamp by a random error with a given maximum.</summary>
    sealed class LateSampling(IMotion motion, double maxSeconds) : IMotion
    {
        readonly Random _random = new(5);

        public IReadOnlyList<string> JointNames => motion.JointNames;

        public double CycleSeconds => motion.CycleSeconds;

        public void At(double seconds, Span<double> positions) => motion.At(seconds + maxSeconds * (2 * _random.NextDouble() - 1), positions);
    }
}
