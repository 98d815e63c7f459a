namespace Nowpose.Cli.Replay;

/// <summary>Collects the errors of one axis, and the standard deviations that the predictor states.</summary>
sealed class AxisError
{
    /// <summary>Minimum error of hold, in the unit of the axis, in a frame in which the axis counts as moving.</summary>
    const double MinMoving = 1e-3;

    readonly ErrorCollector _errors = new();
    readonly Shares _all = new(), _moving = new();
    double _deviations;
    double _squares;

    /// <summary>Number of frames added so far.</summary>
    public int Count => _errors.Count;

    /// <param name="deviation">Standard deviation that the predictor states for this prediction; NaN if unknown.</param>
    public void Add(double held, double predicted, double deviation)
    {
        _errors.Add(held, predicted);
        if (double.IsNaN(deviation)) return;
        _deviations += deviation;
        _squares += deviation * deviation;
        _all.Add(predicted, deviation);
        if (Math.Abs(held) > MinMoving) _moving.Add(predicted, deviation);
    }

    public ReplayResult.Axis Summary(string name) => new(name, _errors.Result())
    {
        Deviation = _all.Count == 0 ? null
            : new ReplayResult.Deviation(_deviations / _all.Count, Math.Sqrt(_squares / _all.Count), _all.Result(), _moving.Result()),
    };

    sealed class Shares
    {
        int _insideOne;
        int _insideTwo;

        public int Count { get; private set; }

        public void Add(double error, double deviation)
        {
            Count++;
            if (Math.Abs(error) <= deviation) _insideOne++;
            if (Math.Abs(error) <= 2 * deviation) _insideTwo++;
        }

        public ReplayResult.Coverage Result() => Count == 0 ? default : new(Count, (double)_insideOne / Count, (double)_insideTwo / Count);
    }
}
