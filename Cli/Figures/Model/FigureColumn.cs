namespace Nowpose.Cli.Figures.Model;

/// <summary>A column of a figure's data.</summary>
/// <param name="Name">Words with hyphens or spaces: "quadratic-h3".</param>
/// <param name="Unit">"mm", "mm/s" or empty for a number without one.</param>
readonly record struct FigureColumn(string Name, string Unit = "")
{
    /// <summary>As files name columns: <c>quadratic_h3_mm</c>, <c>speed_mm_per_s</c>.</summary>
    public string Header => Plain(Unit.Length == 0 ? Name : $"{Name}_{Unit.Replace("/", "_per_", StringComparison.Ordinal)}");

    /// <summary>As people read it: <c>quadratic-h3 (mm)</c>.</summary>
    public string Label => Unit.Length == 0 ? Name : $"{Name} ({Unit})";

    static string Plain(string text) => text.Replace(' ', '_').Replace('-', '_').Replace("µ", "u", StringComparison.Ordinal)
        .Replace("²", "2", StringComparison.Ordinal).Replace("³", "3", StringComparison.Ordinal);
}
