using Nowpose.Cli.Studies;
using Nowpose.Gateway.MotionRecordings;
using Nowpose.Simulation;

namespace Nowpose.Benchmarks.Ablation;

/// <summary>Creates simulated motions of objects: machines that switch abruptly, smooth moves, vehicles, hands, and trackers with noise and outliers.</summary>
static class ObjectMotions
{
    const double RowsPerSecond = 200, Seconds = 30, Mm = 1e-3;

    const int Rows = (int)(Seconds * RowsPerSecond) + 1;

    static readonly string[] Columns = ["x", "y", "z", "qx", "qy", "qz", "qw"];

    public static IReadOnlyList<(string Name, MotionRecording Recording)> All(int seed) =>
    [
        Noiseless("carried workpiece", Along(Motions.FastMoves(seed), Motions.GentleMoves(seed + 1), Motions.Trapezoids(seed + 2, Seconds))),
        Noiseless("repeated moves", Along(Motions.Repeats(seed, default), Motions.Repeats(seed + 1, default), Motions.Repeats(seed + 2, default))),
        Noiseless("switched turntable", Turntable(Switched(seed, 1.5))),
        Noiseless("conveyor, replaced workpieces", Conveyor(Switched(seed + 1, 0.4))),
        Noiseless("stopped carrier", Along(Motions.EmergencyStops(seed), Motions.SoftMoves(seed + 1), Motions.EmergencyStops(seed + 2))),
        Tracked("vehicle", seed, 2e-3, 0.005, 0, Vehicle(Switched(seed + 2, 0.8), Switched(seed + 3, 0.6))),
        Tracked("hand", seed + 1, 0.5e-3, 0.003, 0, Along(Motions.Waves(seed), Motions.Waves(seed + 1), Motions.Waves(seed + 2))),
        Tracked("hand, outliers", seed + 2, 0.5e-3, 0.003, 0.01, Along(Motions.Waves(seed + 3), Motions.Waves(seed + 4), Motions.Waves(seed + 5))),
        Tracked("moved between rests", seed + 3, 1e-3, 0.005, 0, Along(Motions.GentleMoves(seed + 3), Motions.GentleMoves(seed + 4), Motions.GentleMoves(seed + 5))),
    ];

    /// <summary>Position in m, and the angle about the vertical axis in rad.</summary>
    readonly record struct Pose(double X, double Y, double Angle);

    // The angle follows the third motion, 2 mrad per mm.
    static Func<double, Pose> Along(AxisMotion x, AxisMotion y, AxisMotion angle) => t => new Pose(x.At(t) * Mm, y.At(t) * Mm, 2 * angle.At(t) * Mm);

    static Func<double, Pose> Turntable(Func<double, double> angle) => t => new Pose(0.3 * Math.Cos(angle(t)), 0.3 * Math.Sin(angle(t)), angle(t));

    // Each workpiece is picked up after 0.8 m and the next one starts at the other end, turned by another angle.
    static Func<double, Pose> Conveyor(Func<double, double> distance) => t =>
    {
        var workpiece = Math.Floor(distance(t) / 0.8);
        return new Pose(distance(t) - 0.8 * workpiece, 0, workpiece % 3);
    };

    static Func<double, Pose> Vehicle(Func<double, double> distance, Func<double, double> turned)
    {
        var poses = new Pose[Rows];
        for (var row = 1; row < Rows; row++)
        {
            var (from, to) = ((row - 1) / RowsPerSecond, row / RowsPerSecond);
            var (step, angle) = (distance(to) - distance(from), turned(to));
            poses[row] = new Pose(poses[row - 1].X + step * Math.Cos(angle), poses[row - 1].Y + step * Math.Sin(angle), angle);
        }
        return t => poses[Math.Clamp((int)Math.Round(t * RowsPerSecond), 0, Rows - 1)];
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
        return t =>
        {
            var after = times.FindIndex(1, time => time >= t);
            var share = (t - times[after - 1]) / (times[after] - times[after - 1]);
            return positions[after - 1] + share * (positions[after] - positions[after - 1]);
        };
    }

    static (string, MotionRecording) Noiseless(string name, Func<double, Pose> at) => Tracked(name, 0, 0, 0, 0, at);

    static (string, MotionRecording) Tracked(string name, int seed, double noise, double angleNoise, double outliers, Func<double, Pose> at)
    {
        var random = new Random(seed);
        var (times, positions) = (new double[Rows], new List<double>(Rows * Columns.Length));
        for (var row = 0; row < Rows; row++)
        {
            times[row] = row / RowsPerSecond;
            var (x, y, angle) = at(times[row]);
            var outlier = random.NextDouble() < outliers ? 0.3 : 0;
            var half = (angle + angleNoise * random.NextNormal()) / 2;
            positions.AddRange([
                x + noise * random.NextNormal() + outlier, y + noise * random.NextNormal(), noise * random.NextNormal(), 0, 0, Math.Sin(half), Math.Cos(half),
            ]);
        }
        return (name, new MotionRecording(Columns, 0, times, [.. positions]) { IsBody = true });
    }
}
