using System.Globalization;

namespace Nowpose.Cli.Replay;

/// <summary>Writes the values of all scored frames as CSV: one row for each axis of a frame.</summary>
/// <param name="axes">The axes of the joints or of the rigid body.</param>
sealed class FrameTable(TextWriter to, IReadOnlyList<(string Name, string Unit)> axes)
{
    /// <summary>
    /// The columns. Their units: t_s in s, those from <c>truth</c> to <c>sd</c> in the unit of the row, light_ns in ns. object and frame have the object
    /// and the frame of its poses; they are empty for other axes. light_ns is t_s as a whole number, because a double cannot hold seconds since 1970
    /// precisely.
    /// </summary>
    public const string Header = "t_s,axis,unit,truth,hold,predicted,sd,object,frame,pass,light_ns";

    public void WriteHeader() => to.Write(Header + "\n");

    public void Write(ScoredValue value) => Write(value, axes[value.Axis], "", "");

    /// <summary>Writes the value of an object of a session.</summary>
    /// <param name="name">Name of the object.</param>
    /// <param name="frame">Name of the frame in which its poses are compared.</param>
    /// <param name="value">Value of one of <see cref="BodyReplay.Axes"/>.</param>
    public void WriteObject(string name, string frame, ScoredValue value) => Write(value, BodyReplay.Axes[value.Axis], name, frame);

    void Write(in ScoredValue value, in (string Name, string Unit) axis, string name, string frame) => to.Write(
        string.Create(CultureInfo.InvariantCulture, $"{value.Ticks / (decimal)TimeSpan.TicksPerSecond},{CsvField.Quoted(axis.Name)},{axis.Unit},")
        + string.Create(CultureInfo.InvariantCulture, $"{value.Truth:R},{value.Held:R},{value.Predicted:R},{Known(value.Deviation)},")
        + string.Create(CultureInfo.InvariantCulture, $"{CsvField.Quoted(name)},{CsvField.Quoted(frame)},{value.Pass},")
        + string.Create(CultureInfo.InvariantCulture, $"{value.Ticks * TimeSpan.NanosecondsPerTick}\n"));

    // The deviation is empty if it is unknown.
    static string Known(double deviation) => double.IsNaN(deviation) ? "" : deviation.ToString("R", CultureInfo.InvariantCulture);
}
