namespace Nowpose.Benchmarks.Competitors;

/// <summary>A Kalman filter with position, velocity and acceleration, driven by white jerk.</summary>
/// <param name="jerkToNoise">
/// Spectral density of the jerk divided by the variance of a position, s⁻⁵. Only their ratio matters, so the variance is 1 here.
/// </param>
sealed class KalmanFilter(double jerkToNoise) : RecursiveFilter
{
    // Variance of an unknown velocity or acceleration. Very large, but within the precision of double.
    const double Unknown = 1e9;

    double _position, _velocity, _acceleration;

    // Upper triangle of the symmetric covariance matrix.
    double _pp, _pv, _pa, _vv, _va, _aa;

    protected override void Start(double position)
    {
        (_position, _velocity, _acceleration) = (position, 0, 0);
        (_pp, _pv, _pa, _vv, _va, _aa) = (1, 0, 0, Unknown, 0, Unknown);
    }

    protected override void Update(double interval, double position)
    {
        Predict(interval);
        Correct(position - _position);
    }

    protected override double PositionAt(double ahead) => _position + ahead * (_velocity + ahead / 2 * _acceleration);

    // x = F x, P = F P F' + Q.
    void Predict(double t)
    {
        _position += t * (_velocity + t / 2 * _acceleration);
        _velocity += t * _acceleration;

        var half = t * t / 2;
        // Rows of F P.
        var (pp, pv, pa) = (_pp + t * _pv + half * _pa, _pv + t * _vv + half * _va, _pa + t * _va + half * _aa);
        var (vv, va) = (_vv + t * _va, _va + t * _aa);
        var q = jerkToNoise * t;
        _pp = pp + t * pv + half * pa + q * half * half / 5;
        _pv = pv + t * pa + q * t * half / 4;
        _pa = pa + q * half / 3;
        _vv = vv + t * va + q * t * t / 3;
        _va = va + q * t / 2;
        _aa += q;
    }

    void Correct(double innovation)
    {
        var gain = 1 / (_pp + 1);
        var (p, v, a) = (_pp * gain, _pv * gain, _pa * gain);
        _position += p * innovation;
        _velocity += v * innovation;
        _acceleration += a * innovation;
        _vv -= v * _pv;
        _va -= v * _pa;
        _aa -= a * _pa;
        _pv *= gain;
        _pa *= gain;
        _pp *= gain;
    }
}
