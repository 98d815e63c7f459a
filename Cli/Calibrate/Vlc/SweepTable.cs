using Nowpose.Gateway.MotionRecordings;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Sweep;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Reads the log of a load sweep, plain or compressed.</summary>
static class SweepTable
{
    /// <param name="conditions">Conditions of the whole sweep.</param>
    /// <exception cref="InputException">The file cannot be read, has another format, or contains several headsets.</exception>
    public static IReadOnlyList<SweepRow> Read(string path, out DisplayConditions conditions)
    {
        var (rows, others) = RecordingText.Read(path, text => (SweepLogReader.Read(text, path, out var found), found));
        conditions = new DisplayConditions(Device(rows), DisplayHz(rows)).Or(others);
        return rows;
    }

    /// <summary>Gets the headset's model; empty if no row contains it.</summary>
    public static string Device(IReadOnlyList<SweepRow> rows) => rows.Select(row => row.Device).FirstOrDefault(device => device.Length > 0) ?? "";

    /// <summary>Gets the display rate; 0 if no row contains it. A display reports its rate only some frames after the scene has started.</summary>
    public static double DisplayHz(IReadOnlyList<SweepRow> rows) => rows.Select(row => row.DisplayHz).FirstOrDefault(rate => !double.IsNaN(rate));
}
