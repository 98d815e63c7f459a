namespace Nowpose.Benchmarks.Paths;

/// <summary>A change of a path's minimum delays.</summary>
/// <param name="Name">Description of the change in the table.</param>
/// <param name="Extra">
/// Gets the additional delays, as multiples of the size of the change. The argument is the time since the change, s; it is negative before the
/// change.
/// </param>
/// <param name="Limit">Minimum error of any estimator after the change, relative to its size: half the difference between both directions.</param>
sealed record PathChange(string Name, Func<double, (double Up, double Down)> Extra, double Limit)
{
    /// <summary>Time after which a temporary change ends, s.</summary>
    const double Stay = 100;

    public static readonly PathChange None = new("no change", _ => (0, 0), 0);

    public static readonly IReadOnlyList<PathChange> All =
    [
        new("requests longer", since => (since < 0 ? 0 : 1, 0), 0.5),
        new("replies longer", since => (0, since < 0 ? 0 : 1), 0.5),
        new("both longer", since => since < 0 ? (0, 0) : (1, 0.5), 0.25),
        new("longer and back", since => (since is < 0 or > Stay ? 0 : 1, 0), 0.5),
        new("shorter than ever", since => (since < 0 ? 1 : 0, 0), 0.5),
        new("requests longer, replies shorter", since => since < 0 ? (0, 0.25) : (1, 0), 0.625),
        new("requests shorter, replies longer", since => since < 0 ? (0.25, 0) : (0, 1), 0.625),
        new("requests much shorter, replies longer", since => since < 0 ? (1, 0) : (0, 0.25), 0.625),
    ];
}
