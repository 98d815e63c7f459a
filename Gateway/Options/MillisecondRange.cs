namespace Nowpose.Gateway.Options;

/// <summary>A range of durations, ms. Its text is the form that a user types: MIN-MAX.</summary>
public readonly record struct MillisecondRange(double Min, double Max)
{
    public override string ToString() => FormattableString.Invariant($"{Min}-{Max}");
}
