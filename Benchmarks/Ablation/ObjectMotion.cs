using Nowpose.Gateway.MotionRecordings;
using Nowpose.Simulation;

namespace Nowpose.Benchmarks.Ablation;

/// <summary>Position in m, and the angle about the vertical axis in rad.</summary>
readonly record struct ObjectPose(double X, double Y, double Angle);

/// <summary>A simulated motion of an object of 30 s, and how a tracker measures it.</summary>
/// <param name="at">Returns the pose at a time in s.</param>
/// <param name="noise">Standard deviation of the position, m.</param>
/// <param name="angleNoise">Standard deviation of the angle, rad.</param>
/// <param name="outliers">Share of samples that are 0.3 m away.</param>
sealed class ObjectMotion(string name, Func<double, ObjectPose> at, double noise = 0, double angleNoise = 0, double outliers = 0)
{
    /// <summary>Duration, s.</summary>
    public const double Seconds = 30;

    /// <summary>Rate of the recordings.</summary>
    public const double RowsPerSecond = 200;

    public const int Rows = (int)(Seconds * RowsPerSecond) + 1;

    static readonly string[] Columns = ["x", "y", "z", "qx", "qy", "qz", "qw"];

    public string Name => name;

    /// <summary>Returns a motion through poses, one per row of the recording.</summary>
    public static Func<double, ObjectPose> Through(ObjectPose[] poses) => t => poses[Math.Clamp((int)Math.Round(t * RowsPerSecond), 0, Rows - 1)];

    /// <summary>Seed of the noise.</summary>
    public int Seed { get; init; }

    /// <summary>Whether the measured position is not always the same.</summary>
    public bool Moves => noise > 0 || Enumerable.Range(0, Rows).Any(row => (PoseOf(row).X, PoseOf(row).Y) != (PoseOf(0).X, PoseOf(0).Y));

    /// <summary>Whether the measured angle is not always the same.</summary>
    public bool Turns => angleNoise > 0 || Enumerable.Range(0, Rows).Any(row => PoseOf(row).Angle != PoseOf(0).Angle);

    public MotionRecording Record()
    {
        var random = new Random(Seed);
        var (times, positions) = (new double[Rows], new List<double>(Rows * Columns.Length));
        for (var row = 0; row < Rows; row++)
        {
            times[row] = row / RowsPerSecond;
            var (x, y, angle) = PoseOf(row);
            var outlier = random.NextDouble() < outliers ? 0.3 : 0;
            var half = (angle + angleNoise * random.NextNormal()) / 2;
            positions.AddRange([
                x + noise * random.NextNormal() + outlier, y + noise * random.NextNormal(), noise * random.NextNormal(), 0, 0, Math.Sin(half), Math.Cos(half),
            ]);
        }

        return new MotionRecording(Columns, 0, times, [.. positions]) { IsBody = true };
    }

    ObjectPose PoseOf(int row) => at(row / RowsPerSecond);
}
