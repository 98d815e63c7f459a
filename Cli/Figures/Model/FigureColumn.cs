namespace Nowpose.Cli.Figures.Model;

/// <summary>A column of a figure's data.</summary>
/// <param name="Name">Name, which can contain hyphens and spaces, for example "quadratic-h3".</param>
/// <param name="Unit">Unit, for example "mm" or "mm/s"; empty for a dimensionless number.</param>
readonly record struct FigureColumn(string Name, string Unit = "")
{
    /// <summary>Name of the column in files, for example <c>quadratic_h3_mm</c> or <c>speed_mm_per_s</c>.</summary>
    public string Header => Plain(Unit.Length == 0 ? Name : $"{Name}_{Unit.Replace("/", "_per_", StringComparison.Ordinal)}");

    /// <summary>Name of the column for readers, for example <c>quadratic-h3 (mm)</c>.</summary>
    public string Label => Unit.Length == 0 ? Name : $"{Name} ({Unit})";

    static string Plain(string text) => text.Replace(' ', '_').Replace('-', '_').Replace("µ", "u", StringComparison.Ordinal)
        .Replace("²", "2", StringComparison.Ordinal).Replace("³", "3", StringComparison.Ordinal);
}
