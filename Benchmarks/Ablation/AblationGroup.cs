using Nowpose.Cli.Replay;
using Nowpose.Cli.Studies;
using Nowpose.Frames;
using Nowpose.Gateway.MotionRecordings;
using Nowpose.Prediction;

namespace Nowpose.Benchmarks.Ablation;

/// <summary>
/// A group of runs that is reported in one column: recordings, simulated motions, simulated motions with errors in the time stamps, or objects.
/// </summary>
/// <param name="name">Name of the group in the table.</param>
sealed class AblationGroup(string name, IReadOnlyList<AblationRun> runs)
{
    static readonly string[] Fixed = ["hold", "linear", "quadratic", "quadratic-h3", "quadratic-h4", "cubic"];

    /// <summary>Sampling intervals and latencies, s.</summary>
    static readonly (double Interval, double Latency)[] Conditions = [(0.020, 0.100), (0.050, 0.100), (0.100, 0.150)];

    /// <summary>
    /// Seeds of the simulated motions. Parts and constants of the predictor were selected with them, so the results are not an independent test;
    /// <see cref="HeldOut"/> has other seeds.
    /// </summary>
    static readonly int[] Seeds = [6101, 6102, 6103];

    /// <summary>First of the seeds of <see cref="HeldOut"/>. Do not select anything with these seeds.</summary>
    const int FirstHeldOutSeed = 970_001;

    /// <summary>Limits of <see cref="Motions.MovesOfOneDrive"/>. The limits of the other motions are unknown.</summary>
    static readonly PredictionLimits DriveLimits = new(horizonCap: double.PositiveInfinity, maximumGap: double.PositiveInfinity,
        velocity: 1000, acceleration: 5000, jerk: 50_000);

    static readonly Func<int, AxisMotion>[] SimulatedMotions =
    [
        _ => Motions.PaperSwing(), seed => Motions.FastMoves(seed), seed => Motions.GentleMoves(seed), seed => Motions.SoftMoves(seed),
        seed => Motions.Trapezoids(seed), seed => Motions.Waves(seed), seed => Motions.EmergencyStops(seed), seed => Motions.Ringing(seed),
        seed => Motions.Jumps(seed), seed => Motions.Repeats(seed, new CycleVariation(0.05, 1, 0.01)), Motions.MovesOfOneDrive,
    ];

    public string Name => name;

    /// <summary>Names of the errors, in the order of <see cref="Errors"/>.</summary>
    public IReadOnlyList<string> Names { get; } = [.. runs.SelectMany(run => run.Names)];

    /// <param name="recordings">Folder with recorded motions; null for none.</param>
    /// <param name="motions">Text in the names of the motions; null for all.</param>
    public static IReadOnlyList<AblationGroup> All(string recordings, string motions)
    {
        var groups = new List<AblationGroup> { Simulated("simulated", 0, Seeds), Simulated("stamps ±5 ms", 0.005, Seeds),
            Objects("objects", [.. ObjectMotions.All(Seeds[0])]), Objects("first turns", [.. TurningMotions.All(Seeds[0])]) };
        if (recordings != null) groups.Insert(0, Recorded(recordings));
        if (motions == null) return groups;
        var selected = groups.Select(group => group.Only(motions)).Where(group => group.Names.Count > 0).ToList();
        return selected.Count > 0 ? selected
            : throw new InputException($"--motions: no name contains '{motions}'; the names are {string.Join("; ", groups.SelectMany(group => group.Names))}");
    }

    AblationGroup Only(string motions) => new(name, [.. runs.Where(run => run.Names[0].Contains(motions, StringComparison.OrdinalIgnoreCase))]);

    /// <summary>Gets the simulated motions with seeds with which nothing was selected, three for each set.</summary>
    public static IEnumerable<AblationGroup> HeldOut(int sets) => Enumerable.Range(0, sets).Select(set =>
        Simulated(FormattableString.Invariant($"set {set + 1}"), 0, [.. Enumerable.Range(FirstHeldOutSeed + set * Seeds.Length, Seeds.Length)]));

    /// <summary>Gets the RMS errors of the default predictor, for each group.</summary>
    public static double[][] Errors(IReadOnlyList<AblationGroup> groups) => [.. groups.Select(group => group.Errors(Predictors.Default))];

    /// <summary>Gets the RMS errors of a predictor in all runs.</summary>
    /// <param name="without">Parts that are removed from the default predictor.</param>
    public double[] Errors(string predictor, PredictionParts without = PredictionParts.None) =>
        [.. runs.AsParallel().AsOrdered().SelectMany(run => run.Rms(predictor, without))];

    /// <summary>Gets the smallest RMS error of all predictors with fixed parameters, for each error.</summary>
    public double[] MinFixedErrors() => [.. Fixed.Select(one => Errors(one)).Aggregate((a, b) => [.. a.Zip(b, Math.Min)])];

    static AblationGroup Simulated(string name, double stampError, int[] seeds) => new(name,
    [
        .. from motion in SimulatedMotions
           from condition in Conditions
           select new AblationRun([Label(motion(0).Name, condition)], (predictor, without) => [Math.Sqrt(seeds.Average(seed => Square(
               PredictionStudy.Run(motion(seed), SettingsOf(condition, seed) with { StampError = stampError }, () => Joint(predictor, LimitsOf(motion), without)).Rms)))]),
    ]);

    static StudySettings SettingsOf((double Interval, double Latency) condition, int seed) =>
        new() { SamplingInterval = condition.Interval, Latency = condition.Latency, Seed = seed, Phases = 2 };

    static AblationGroup Recorded(string folder) => new("recordings",
    [
        .. from path in Directory.EnumerateFiles(folder, "*.csv*").Order(StringComparer.Ordinal)
           let recording = MotionRecording.Read(path)
           from condition in Conditions
           select new AblationRun([Label(Path.GetFileName(path), condition)], (predictor, without) =>
               [new ReplayRun(path, recording, Replayed(condition), () => Joint(predictor, PredictionLimits.Unlimited, without)).Run().Rms]),
    ]);

    static AblationGroup Objects(string name, ObjectMotion[] motions) => new(name,
    [
        .. from motion in motions
           let recording = motion.Record()
           let changes = new[] { motion.Moves, motion.Turns }
           from condition in Conditions
           let label = Label(motion.Name, condition)
           select new AblationRun(OfThose(changes, label + ", position", label + ", rotation"), (predictor, without) =>
           {
               var result = new BodyReplay(motion.Name, recording, Replayed(condition), () => Object(predictor, without)).Run();
               return OfThose(changes, result.Position.Rms, result.Rotation.Rms);
           }),
    ]);

    // An error that is always 0 has no ratio.
    static T[] OfThose<T>(bool[] changes, params T[] values) => [.. values.Where((_, i) => changes[i])];

    static ReplaySettings Replayed((double Interval, double Latency) condition) =>
        new() { SamplingInterval = condition.Interval, Latency = condition.Latency };

    static PredictionLimits LimitsOf(Func<int, AxisMotion> motion) => motion == Motions.MovesOfOneDrive ? DriveLimits : PredictionLimits.Unlimited;

    static JointPredictor Joint(string predictor, PredictionLimits limits, PredictionParts without) => without == PredictionParts.None
        ? Predictors.Create(predictor, limits) : Predictors.Adaptive(limits, PredictionParts.Joint & ~without);

    static BodyPredictor Object(string predictor, PredictionParts without) =>
        new(predictor, PredictionLimits.Unlimited, parts: PredictionParts.Object & ~without);

    static string Label(string motion, (double Interval, double Latency) condition) =>
        FormattableString.Invariant($"{motion}, {condition.Interval * 1e3:0} / {condition.Latency * 1e3:0} ms");

    static double Square(double x) => x * x;
}

/// <summary>One motion under one condition.</summary>
/// <param name="Names">Names of the errors in tables: one for a joint or several joints, two for the position and rotation of an object.</param>
/// <param name="Rms">Computes the RMS errors of a predictor, without the given parts if it is the default one, in the units of the motion.</param>
sealed record AblationRun(IReadOnlyList<string> Names, Func<string, PredictionParts, double[]> Rms);
