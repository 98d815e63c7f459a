using MathNet.Numerics.Interpolation;
using Nowpose.Cli.Replay;
using Nowpose.Gateway.MotionRecordings;

namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>Positions of robot and hologram, resampled to the same regular time grid on one clock.</summary>
/// <param name="Start">Time of the first instant, as in the file, s.</param>
/// <param name="Interval">The camera's interval, s.</param>
/// <param name="Robot">Position of the robot, in any unit.</param>
/// <param name="Shown">Position of the hologram, in any unit.</param>
sealed record SineTracks(double Start, double Interval, double[] Robot, double[] Shown)
{
    const int MinInstants = 60;

    /// <summary>Time by which a rolling shutter exposes the hologram later than the robot, ms.</summary>
    public double LaterMs { get; init; }

    /// <summary>Reads both tracks from one recording.</summary>
    /// <param name="columns">Names of the two columns. If null, the file must have exactly two columns of positions, the robot's first.</param>
    public static SineTracks Of(string path, string columns)
    {
        var recording = MotionRecording.Read(path);
        var (robot, shown) = Columns(recording, path, columns);
        return OnGrid(recording, recording, robot, shown, path);
    }

    /// <summary>Reads the hologram's track from a camera's file and the robot's from a control system's file. Both use the same clock.</summary>
    /// <param name="joint">Column of the control system's file. If null, the file must have exactly one column of positions.</param>
    public static SineTracks Of(string path, string columns, string controlPath, string joint)
    {
        var camera = MotionRecording.Read(path);
        var control = MotionRecording.Read(controlPath);
        return OnGrid(control, camera, One(control, controlPath, joint, "--joint"), One(camera, path, columns, "--columns"), path);
    }

    static (int Robot, int Shown) Columns(MotionRecording recording, string path, string columns)
    {
        var names = columns?.Split(',', StringSplitOptions.TrimEntries);
        if (names == null && recording.Names.Count == 2) return (0, 1);
        if (names?.Length != 2)
            throw new InputException(SineMessages.ColumnsNeeded(path, recording.Names.Count));
        if (names[0] == names[1]) throw new InputException(SineMessages.SameColumn(names[0]));
        return (IndexOf(recording, path, names[0], "--columns"), IndexOf(recording, path, names[1], "--columns"));
    }

    static int One(MotionRecording recording, string path, string name, string option)
    {
        if (name != null) return IndexOf(recording, path, name, option);
        return recording.Names.Count == 1 ? 0 : throw new InputException(SineMessages.ColumnNeeded(path, recording.Names.Count, option));
    }

    static int IndexOf(MotionRecording recording, string path, string name, string option)
    {
        for (var i = 0; i < recording.Names.Count; i++)
            if (recording.Names[i] == name) return i;
        throw new InputException(SineMessages.UnknownColumn(option, path, name, string.Join(", ", recording.Names)));
    }

    /// <summary>Creates the tracks from positions of robot and hologram at the same times.</summary>
    /// <param name="times">Increasing times, s.</param>
    public static SineTracks Of(double[] times, double[] robot, double[] shown, string path)
    {
        // A single picture gives no line; OnGrid rejects it.
        Func<double, double> At(double[] places) => times.Length < 2 ? null : LinearSpline.InterpolateSorted(times, places).Interpolate;
        return OnGrid(times[0], times[^1], RowInterval.Of(times), At(robot), At(shown), path);
    }

    static SineTracks OnGrid(MotionRecording robot, MotionRecording shown, int robotColumn, int shownColumn, string path)
    {
        Func<double, double> At(MotionRecording of, int column)
        {
            var row = new double[of.Names.Count];
            return time =>
            {
                of.At(time - of.Start, row);
                return row[column];
            };
        }
        return OnGrid(
            Math.Max(robot.Start, shown.Start), Math.Min(robot.Start + robot.Duration, shown.Start + shown.Duration), RowInterval.Of(shown.Times),
            At(robot, robotColumn), At(shown, shownColumn), path);
    }

    static SineTracks OnGrid(double start, double end, double interval, Func<double, double> robot, Func<double, double> shown, string path)
    {
        var count = (int)Math.Floor((end - start) / interval + 1e-6) + 1;
        if (!(end > start) || count < MinInstants)
            throw new InputException(SineMessages.TooFewPictures(path, Math.Max(0, count), MinInstants));
        double[] times = [.. Enumerable.Range(0, count).Select(i => start + i * interval)];
        return new SineTracks(start, interval, [.. times.Select(robot)], [.. times.Select(shown)]);
    }
}
