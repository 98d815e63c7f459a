using Nowpose.Frames;
using Nowpose.Gateway.MotionRecordings;
using Nowpose.Kinematics;

namespace Nowpose.Cli.Replay;

/// <summary>The true pose of a recorded rigid body. The position is interpolated linearly, the rotation by slerp.</summary>
sealed class BodyTruth
{
    readonly double[] _times;
    readonly double[][] _positions;
    readonly UnitQuaternion[] _rotations;

    public BodyTruth(MotionRecording recording)
    {
        _times = [.. recording.Times];
        _positions = [recording.PositionsOf(0), recording.PositionsOf(1), recording.PositionsOf(2)];
        var (x, y, z, w) = (recording.PositionsOf(3), recording.PositionsOf(4), recording.PositionsOf(5), recording.PositionsOf(6));
        _rotations = new UnitQuaternion[_times.Length];
        for (var row = 0; row < _rotations.Length; row++) UnitQuaternion.TryNormalise(x[row], y[row], z[row], w[row], out _rotations[row]);
    }

    /// <param name="samples">Two samples or more, with increasing times.</param>
    public BodyTruth(IReadOnlyList<PoseSample> samples)
    {
        _times = [.. samples.Select(sample => sample.Time)];
        _positions = [[.. samples.Select(sample => sample.Position.X)], [.. samples.Select(sample => sample.Position.Y)], [.. samples.Select(sample => sample.Position.Z)]];
        _rotations = [.. samples.Select(sample => sample.Rotation)];
    }

    /// <summary>Gets the interval between the last sample before a time and the first sample after it, s; infinite outside the recording.</summary>
    public double GapAt(double time) => time < _times[0] || time > _times[^1] ? double.PositiveInfinity : _times[RowAfter(time)] - _times[RowAfter(time) - 1];

    /// <summary>
    /// Returns the pose at a given time since the start of the recording, s. Outside the recording, returns the first or the last pose.
    /// </summary>
    public (double X, double Y, double Z, UnitQuaternion Rotation) At(double time)
    {
        var after = RowAfter(time);
        var share = Math.Clamp((time - _times[after - 1]) / (_times[after] - _times[after - 1]), 0, 1);
        double Between(double[] values) => values[after - 1] + (values[after] - values[after - 1]) * share;
        return (Between(_positions[0]), Between(_positions[1]), Between(_positions[2]),
            UnitQuaternion.Slerp(_rotations[after - 1], _rotations[after], share));
    }

    int RowAfter(double time)
    {
        var found = Array.BinarySearch(_times, time);
        return Math.Clamp(found < 0 ? ~found : found + 1, 1, _times.Length - 1);
    }
}
