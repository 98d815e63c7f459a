namespace Nowpose.Cli.Demo;

/// <summary>
/// The scene's load over a run. It begins after the first third and ends before the last quarter, so that both changes are visible.
/// </summary>
/// <param name="Vertices">Number of vertices during the load; 0 before and after it.</param>
/// <param name="Seconds">Length of the whole run.</param>
readonly record struct DemoLoad(double Vertices, double Seconds)
{
    public double FromSeconds => Seconds / 3;

    public double ToSeconds => Seconds * 3 / 4;

    /// <param name="elapsed">Time since the run began.</param>
    public double VerticesAt(TimeSpan elapsed) =>
        elapsed.TotalSeconds >= FromSeconds && elapsed.TotalSeconds < ToSeconds ? Vertices : 0;
}
