using System.Globalization;

namespace Nowpose.Cli.Replay;

/// <summary>Writes the values of all scored frames as CSV: one row for each axis of a frame.</summary>
sealed class FrameTable(TextWriter to, IReadOnlyList<(string Name, string Unit)> axes)
{
    /// <summary>Units of the columns: t_s in s, all others in the unit of the row.</summary>
    public const string Header = "t_s,axis,unit,truth,hold,predicted,sd";

    public void WriteHeader() => to.Write(Header + "\n");

    public void Write(ScoredValue value)
    {
        var (name, unit) = axes[value.Axis];
        to.Write(string.Create(CultureInfo.InvariantCulture,
            $"{value.Ticks / (decimal)TimeSpan.TicksPerSecond},{CsvField.Quoted(name)},{unit},{value.Truth:R},{value.Held:R},{value.Predicted:R},")
            + Known(value.Deviation) + "\n");
    }

    // The deviation is empty if it is unknown.
    static string Known(double deviation) => double.IsNaN(deviation) ? "" : deviation.ToString("R", CultureInfo.InvariantCulture);
}
