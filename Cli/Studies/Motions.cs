using Nowpose.Motion;
using Nowpose.Simulation;

namespace Nowpose.Cli.Studies;

/// <summary>Creates simulated motions in mm. The same seed creates the same motion.</summary>
public static class Motions
{
    /// <summary>A move like that of the paper's Fig. 12: 500 mm, with <see cref="MotionLimits.Default"/>.</summary>
    internal static SevenPhaseProfile PaperMove { get; } = MotionLimits.Default.Move();

    /// <summary>Dwell of the swing after each move, s.</summary>
    const double SwingDwell = 0.4;

    /// <summary>Repeats <see cref="PaperMove"/> forward and backward endlessly, with dwells of 0.4 s.</summary>
    public static AxisMotion PaperSwing(double seconds = 12) => Swing(PaperMove, seconds);

    /// <summary>Repeats a move of 500 mm forward and backward endlessly, with dwells of 0.4 s.</summary>
    internal static AxisMotion Swing(SevenPhaseProfile move, double seconds)
    {
        var half = SwingPeriod(move) / 2;
        return new AxisMotion("paper's swing", seconds, t =>
        {
            if (t <= 0) return 0;
            var inCycle = t % (2 * half);
            return inCycle < half ? move.PositionAt(inCycle) : 500 - move.PositionAt(inCycle - half);
        });
    }

    /// <summary>Gets the time after which the swing with a move repeats, s.</summary>
    internal static double SwingPeriod(SevenPhaseProfile move) => 2 * (move.Duration + SwingDwell);

    /// <summary>Creates fast moves from rest to rest, each with new random limits and a new random stroke.</summary>
    public static AxisMotion FastMoves(int seed, double seconds = 30) => RandomMoves("fast 7-phase moves", seed, seconds, random => new Limits(
        Between(random, 400, 1500), Between(random, 3000, 10_000), Between(random, 30_000, 100_000)));

    /// <summary>Creates fast moves of a single drive, all with the same limits: 1000 mm/s, 5000 mm/s², 50 000 mm/s³.</summary>
    public static AxisMotion MovesOfOneDrive(int seed) => RandomMoves(
        FigurePageTexts.MovesOfOneDrive, seed, 40, _ => new Limits(1000, 5000, 50_000));

    /// <summary>Creates moves of a small robot at teaching speed.</summary>
    public static AxisMotion GentleMoves(int seed, double seconds = 60) => RandomMoves(
        FigurePageTexts.GentleMoves, seed, seconds, random => new Limits(
            Between(random, 200, 600), Between(random, 600, 2500), Between(random, 5000, 25_000)));

    /// <summary>Creates slow moves with low acceleration and jerk.</summary>
    public static AxisMotion SoftMoves(int seed, double seconds = 60) => RandomMoves("soft moves", seed, seconds, random => new Limits(
        Between(random, 100, 300), Between(random, 100, 400), Between(random, 300, 1500)));

    /// <summary>Creates moves with trapezoidal velocity, whose acceleration changes abruptly.</summary>
    public static AxisMotion Trapezoids(int seed, double seconds = 30) => RandomMoves("trapezoidal velocity", seed, seconds, random => new Limits(
        Between(random, 300, 1200), Between(random, 2000, 8000), 1e8));

    /// <summary>Creates moves. About half of them end early in an emergency stop, which takes 30 to 80 ms.</summary>
    public static AxisMotion EmergencyStops(int seed, double seconds = 60)
    {
        var random = new Random(seed);
        var sequence = new MoveSequence();
        sequence.Dwell(Between(random, 0.3, 0.8));
        while (sequence.Seconds < seconds)
        {
            var limits = new Limits(Between(random, 300, 1200), Between(random, 2000, 8000), Between(random, 20_000, 80_000));
            var stroke = NextTarget(random, sequence.End) - sequence.End;
            var profile = new SevenPhaseProfile(stroke, limits.Velocity, limits.Acceleration, limits.Jerk);
            if (random.NextDouble() < 0.5) sequence.Add(sequence.End + stroke, profile.Duration, profile.PositionAt);
            else Stop(sequence, profile, profile.Duration * Between(random, 0.25, 0.75), Between(random, 0.03, 0.08));
            sequence.Dwell(Between(random, 0.2, 1.5));
        }
        return sequence.Motion("emergency stops");
    }

    /// <summary>Creates a sum of five sines below 1.5 Hz, which never rests and does not repeat within the run.</summary>
    public static AxisMotion Waves(int seed, double seconds = 60)
    {
        var random = new Random(seed);
        var waves = Enumerable.Range(0, 5).Select(_ => (
            Size: Between(random, 20, 100), Rate: 2 * Math.PI * Between(random, 0.1, 1.5), Phase: Between(random, 0, 2 * Math.PI))).ToArray();
        return new AxisMotion("sum of sines", seconds, t => waves.Sum(wave => wave.Size * Math.Sin(wave.Rate * t + wave.Phase)));
    }

    /// <summary>Creates a repeated cycle of four moves.</summary>
    /// <param name="variation">Random variation between cycles; the default produces exact repetitions.</param>
    public static AxisMotion Repeats(int seed, CycleVariation variation, int cycles = 12)
    {
        var random = new Random(seed);
        var cycle = Enumerable.Range(0, 4).Select(_ => (
            Target: Between(random, -400, 400), Dwell: Between(random, 0.2, 0.8),
            Limits: new Limits(Between(random, 500, 1200), Between(random, 3000, 8000), Between(random, 30_000, 80_000)))).ToArray();
        var sequence = new MoveSequence();
        sequence.Dwell(0.5);
        for (var i = 0; i < cycles; i++)
            foreach (var (target, dwell, limits) in cycle)
            {
                var share = 1 + variation.SpeedShare * random.NextNormal();
                sequence.MoveTo(
                    target + variation.TargetMm * random.NextNormal(), limits.Velocity * share, limits.Acceleration * share * share,
                    limits.Jerk * share * share * share);
                sequence.Dwell(Math.Max(0.02, dwell + variation.DwellSeconds * random.NextNormal()));
            }
        return sequence.Motion("repeating cycles");
    }

    /// <summary>Creates fast moves, each followed by a damped oscillation of a few millimetres at 4 to 9 Hz.</summary>
    public static AxisMotion Ringing(int seed, double seconds = 30)
    {
        var random = new Random(seed);
        var sequence = new MoveSequence();
        sequence.Dwell(0.5);
        while (sequence.Seconds < seconds)
        {
            sequence.MoveTo(NextTarget(random, sequence.End), Between(random, 400, 1200), Between(random, 4000, 9000), 1e6);
            var (size, rate, decay, dwell) = (Between(random, 3, 12), 2 * Math.PI * Between(random, 4, 9), Between(random, 4, 10), Between(random, 0.6, 1.2));
            sequence.Add(sequence.End, dwell, t => size * Math.Exp(-decay * t) * Math.Sin(rate * t));
        }
        return sequence.Motion("ringing after stops");
    }

    /// <summary>Creates rests that are interrupted by jumps of the position between two samples.</summary>
    public static AxisMotion Jumps(int seed, double seconds = 30)
    {
        var random = new Random(seed);
        var sequence = new MoveSequence();
        while (sequence.Seconds < seconds)
        {
            sequence.Dwell(Between(random, 0.5, 2));
            sequence.Add(sequence.End + Between(random, -200, 200), 0, _ => 0);
        }
        return sequence.Motion("position jumps");
    }

    static AxisMotion RandomMoves(string name, int seed, double seconds, Func<Random, Limits> limitsOf)
    {
        var random = new Random(seed);
        var sequence = new MoveSequence();
        sequence.Dwell(Between(random, 0.2, 0.6));
        while (sequence.Seconds < seconds)
        {
            var limits = limitsOf(random);
            sequence.MoveTo(NextTarget(random, sequence.End), limits.Velocity, limits.Acceleration, limits.Jerk);
            sequence.Dwell(random.NextDouble() < 0.3 ? 0 : Between(random, 0.1, 1.0));
        }
        return sequence.Motion(name);
    }

    // Follows the profile up to a given time, then reduces the speed to zero as a half cosine.
    static void Stop(MoveSequence sequence, SevenPhaseProfile profile, double at, double within)
    {
        var (from, speed) = (sequence.End, profile.VelocityAt(at));
        sequence.Add(from + profile.PositionAt(at), at, profile.PositionAt);
        sequence.Add(sequence.End + speed * within / 2, within,
            t => speed * (t / 2 + within / (2 * Math.PI) * Math.Sin(Math.PI * t / within)));
    }

    static double NextTarget(Random random, double from)
    {
        double target;
        do target = Between(random, -500, 500);
        while (Math.Abs(target - from) < 30);
        return target;
    }

    static double Between(Random random, double low, double high) => low + (high - low) * random.NextDouble();

    readonly record struct Limits(double Velocity, double Acceleration, double Jerk);
}
