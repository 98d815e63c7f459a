namespace Nowpose.Benchmarks.Competitors;

/// <summary>The One-Euro filter (Casiez, Roussel, Vogel 2012). Extrapolates with its filtered velocity.</summary>
/// <param name="minCutoff">f_cmin: cut-off frequency at rest, Hz.</param>
/// <param name="slope">β: increase of the cut-off frequency per unit of velocity, Hz.</param>
/// <param name="velocityCutoff">f_cd: cut-off frequency for the velocity, Hz.</param>
sealed class OneEuroFilter(double minCutoff, double slope, double velocityCutoff) : RecursiveFilter
{
    double _position, _velocity;

    protected override void Start(double position) => (_position, _velocity) = (position, 0);

    protected override void Update(double interval, double position)
    {
        _velocity += Share(velocityCutoff, interval) * ((position - Newest) / interval - _velocity);
        _position += Share(minCutoff + slope * Math.Abs(_velocity), interval) * (position - _position);
    }

    protected override double PositionAt(double ahead) => _position + _velocity * ahead;

    // Weight of a new value in a low-pass filter.
    static double Share(double cutoff, double interval) => 1 / (1 + 1 / (2 * Math.PI * cutoff * interval));
}
