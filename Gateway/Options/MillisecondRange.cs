namespace Nowpose.Gateway.Options;

/// <summary>A range of durations, ms; formatted as it is typed.</summary>
public readonly record struct MillisecondRange(double Min, double Max)
{
    public override string ToString() => FormattableString.Invariant($"{Min}-{Max}");
}
