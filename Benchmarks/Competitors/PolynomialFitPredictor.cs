using MathNet.Numerics;
using Nowpose.Prediction;

namespace Nowpose.Benchmarks.Competitors;

/// <summary>Schnierle &amp; Röck 2022, Eq. (8), for n = h = 2 as one writes it first: MathNet's <c>Fit.Polynomial</c> for each sample.</summary>
public sealed class PolynomialFitPredictor : IJointPredictor
{
    const int Degree = 2;

    readonly List<JointSample> _samples = [];
    double[] _coefficients = [0];

    public double Hold => _samples.Count > 0 ? _samples[^1].Position : 0;

    public double NewestTime => _samples.Count > 0 ? _samples[^1].Time : double.NegativeInfinity;

    public SampleOutcome Add(in JointSample sample)
    {
        var order = sample.Order;
        if (_samples.Exists(other => Math.Abs(other.Order - order) < 1e-6)) return SampleOutcome.Duplicate;
        var place = _samples.FindLastIndex(other => other.Order < order) + 1;
        if (place == 0 && _samples.Count > Degree) return SampleOutcome.TooOld;
        _samples.Insert(place, sample);
        if (_samples.Count > Degree + 1) _samples.RemoveAt(0);
        Solve();
        return sample.Time < NewestTime ? SampleOutcome.Late : SampleOutcome.Accepted;
    }

    public JointPrediction At(double time) => _samples.Count == 0
        ? default
        : new JointPrediction(Polynomial.Evaluate(time - NewestTime, _coefficients), PredictionKind.Predicted);

    public void Reset() => _samples.Clear();

    void Solve()
    {
        var times = _samples.Select(sample => sample.Time - NewestTime).ToArray();
        var positions = _samples.Select(sample => sample.Position).ToArray();
        _coefficients = Fit.Polynomial(times, positions, _samples.Count - 1);
    }
}
