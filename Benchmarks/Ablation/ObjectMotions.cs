using MathNet.Numerics.Interpolation;
using Nowpose.Cli.Studies;

namespace Nowpose.Benchmarks.Ablation;

/// <summary>Creates simulated motions of objects: machines that switch abruptly, smooth moves, vehicles, hands, and trackers with noise and outliers.</summary>
static class ObjectMotions
{
    const double Seconds = ObjectMotion.Seconds, RowsPerSecond = ObjectMotion.RowsPerSecond, Mm = 1e-3;

    public static IReadOnlyList<ObjectMotion> All(int seed) =>
    [
        new("carried workpiece", Along(Motions.FastMoves(seed), Motions.GentleMoves(seed + 1), Motions.Trapezoids(seed + 2, Seconds))),
        new("repeated moves", Along(Motions.Repeats(seed, default), Motions.Repeats(seed + 1, default), Motions.Repeats(seed + 2, default))),
        new("switched turntable", Turntable(Switched(seed, 1.5))),
        new("conveyor, replaced workpieces", Conveyor(Switched(seed + 1, 0.4))),
        new("stopped carrier", Along(Motions.EmergencyStops(seed), Motions.SoftMoves(seed + 1), Motions.EmergencyStops(seed + 2))),
        new("vehicle", Vehicle(Switched(seed + 2, 0.8), Switched(seed + 3, 0.6)), 2e-3, 0.005) { Seed = seed },
        new("hand", Along(Motions.Waves(seed), Motions.Waves(seed + 1), Motions.Waves(seed + 2)), 0.5e-3, 0.003) { Seed = seed + 1 },
        new("hand, outliers", Along(Motions.Waves(seed + 3), Motions.Waves(seed + 4), Motions.Waves(seed + 5)), 0.5e-3, 0.003, 0.01) { Seed = seed + 2 },
        new("moved between rests", Along(Motions.GentleMoves(seed + 3), Motions.GentleMoves(seed + 4), Motions.GentleMoves(seed + 5)), 1e-3, 0.005) { Seed = seed + 3 },
    ];

    // The angle follows the third motion, 2 mrad per mm.
    static Func<double, ObjectPose> Along(AxisMotion x, AxisMotion y, AxisMotion angle) => t => new ObjectPose(x.At(t) * Mm, y.At(t) * Mm, 2 * angle.At(t) * Mm);

    static Func<double, ObjectPose> Turntable(Func<double, double> angle) => t => new ObjectPose(0.3 * Math.Cos(angle(t)), 0.3 * Math.Sin(angle(t)), angle(t));

    // Each workpiece is picked up after 0.8 m and the next one starts at the other end, turned by another angle.
    static Func<double, ObjectPose> Conveyor(Func<double, double> distance) => t =>
    {
        var workpiece = Math.Floor(distance(t) / 0.8);
        return new ObjectPose(distance(t) - 0.8 * workpiece, 0, workpiece % 3);
    };

    static Func<double, ObjectPose> Vehicle(Func<double, double> distance, Func<double, double> turned)
    {
        var poses = new ObjectPose[ObjectMotion.Rows];
        for (var row = 1; row < ObjectMotion.Rows; row++)
        {
            var (from, to) = ((row - 1) / RowsPerSecond, row / RowsPerSecond);
            var (step, angle) = (distance(to) - distance(from), turned(to));
            poses[row] = new ObjectPose(poses[row - 1].X + step * Math.Cos(angle), poses[row - 1].Y + step * Math.Sin(angle), angle);
        }
        return ObjectMotion.Through(poses);
    }

    // Distance of a drive that is switched between constant speeds at random times: forwards, backwards or off.
    static Func<double, double> Switched(int seed, double speed)
    {
        var random = new Random(seed);
        var (times, positions) = (new List<double> { 0 }, new List<double> { 0 });
        while (times[^1] < Seconds)
        {
            var seconds = 0.5 + 2 * random.NextDouble();
            positions.Add(positions[^1] + seconds * speed * (random.Next(4) switch { 0 => 0, 1 => -0.5, _ => 1 }));
            times.Add(times[^1] + seconds);
        }
        return LinearSpline.InterpolateSorted([.. times], [.. positions]).Interpolate;
    }
}
