namespace Nowpose.Cli.Demo;

/// <summary>The scene's load over a run: comes after the first third, goes with the last quarter, so that there is a before and an after.</summary>
/// <param name="Vertices">While it is there; 0 before and afterwards.</param>
/// <param name="Seconds">Of the whole run.</param>
readonly record struct DemoLoad(double Vertices, double Seconds)
{
    public double FromSeconds => Seconds / 3;

    public double ToSeconds => Seconds * 3 / 4;

    /// <param name="elapsed">Since the run began.</param>
    public double VerticesAt(TimeSpan elapsed) =>
        elapsed.TotalSeconds >= FromSeconds && elapsed.TotalSeconds < ToSeconds ? Vertices : 0;
}
