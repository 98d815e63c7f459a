using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;

namespace Nowpose.Cli.Calibrate.Range;

/// <summary>The origin of a table of pairs. Its columns have the same value in each row.</summary>
/// <param name="Source">Source of the render times; <see cref="RenderTimeSourceKind.None"/> if unknown.</param>
/// <param name="Conditions">Conditions of the measurement.</param>
sealed record PairOrigin(RenderTimeSourceKind Source, DisplayConditions Conditions)
{
    static readonly DisplayCondition[] All = Enum.GetValues<DisplayCondition>();

    public static IReadOnlyList<string> Columns { get; } = [SweepLogReader.Source, .. All.Select(DisplayConditionNames.FieldOf)];

    /// <summary>The values in the order of <see cref="Columns"/>; null if unknown.</summary>
    public IEnumerable<string> Values =>
        [Source == RenderTimeSourceKind.None ? null : LatencyNames.RenderTimeSource.NameOf(Source), .. All.Select(condition => Conditions[condition])];

    /// <param name="valueOf">Gets the value of a column; null or empty if unknown.</param>
    /// <exception cref="InputException">A value is invalid.</exception>
    public static PairOrigin Parse(Func<string, string> valueOf) => new(
        SweepLogReader.SourceOf(valueOf(SweepLogReader.Source) ?? ""), DisplayConditions.Parse(condition => valueOf(DisplayConditionNames.FieldOf(condition))));
}
