using System;

namespace Nowpose.Prediction.Stacking
{
    /// <summary>Mixes the forecasts of polynomials and Gaussian processes by how their mixture would have done lately.</summary>
    /// <remarks>
    /// No single one is safe: the paper's quadratic wins on clean swings and loses to a straight line on many real machines.
    /// Each sample tells what the forecasts made one horizon earlier should have said; the weights follow, apart for rest and
    /// motion. At a shock the samples before it are dropped, and what is far beyond anything scored is met by the prior.
    /// A frame reads one table; a sample costs five small solves and some 600 exponentials.
    /// </remarks>
    public sealed class StackedPredictor : IJointPredictor
    {
        const int LongestWindow = 12;

        /// <summary>Seconds after which evidence has faded to 1/e.</summary>
        const double Memory = 20;

        const double Regularisation = 0.2;
        const double ClassRegularisation = 0.5;

        /// <summary>Errors below this share of the recent greatest square teach nothing: of rest there is plenty.</summary>
        const double LeastShareOfSquare = 1e-3;

        /// <summary>A way (squared) that exceeds the mean square of hold by this is beyond what was scored.</summary>
        const double UnheardOf = 30;

        /// <summary>For so long after its start an unheard-of motion is a line, s.</summary>
        const double StartSeconds = 0.08;

        /// <summary>Of two speeds the one is a start or a stop when it is this share of the other.</summary>
        const double StartShare = 0.1;

        const double LeastShare = 1e-3;
        const double Epsilon = 1e-6;
        const double GreatestSquareOfSense = 1e100;

        /// <summary>Share of the memory that must be filled before anything counts as an outlier.</summary>
        const double LeastEvidence = 0.02;

        readonly PredictionLimits _limits;
        readonly ForecastHorizon _horizon = new ForecastHorizon();
        readonly SampleHistory _history = new SampleHistory(LongestWindow);
        readonly ShockDetector _shocks = new ShockDetector();
        readonly StandstillDetector _standstill = new StandstillDetector();
        readonly Forecasters _forecasters = new Forecasters();
        readonly ForecastSnapshots _snapshots = new ForecastSnapshots(Forecasters.Count);
        readonly MixtureWeights _overall = new MixtureWeights(Regularisation, Forecasters.Prior());
        readonly MixtureWeights _moving = new MixtureWeights(ClassRegularisation, Forecasters.Prior());
        readonly MixtureWeights _resting = new MixtureWeights(ClassRegularisation, Forecasters.Prior());
        readonly double[] _prior = Forecasters.Prior();
        readonly double[] _priorWhenTold = Forecasters.PriorWhenTold();
        readonly double[] _line = Forecasters.Only(Forecasters.Linear);
        readonly double[] _hold = Forecasters.Only(Forecasters.Hold);
        readonly OutlierBound _outliers = new OutlierBound();
        readonly double[] _errors = new double[Forecasters.Count];
        readonly double[] _table = new double[ForecastGrid.Points];
        double[] _weights;
        int _connected;
        double _greatestSquare;
        double _start;

        /// <param name="limits">Bounds of time, position and speed.</param>
        public StackedPredictor(PredictionLimits limits)
        {
            _limits = limits ?? throw new ArgumentNullException(nameof(limits));
            Reset();
        }

        /// <inheritdoc/>
        public double Hold => _history.NewestPosition;

        /// <inheritdoc/>
        public double NewestTime => _history.NewestTime;

        /// <inheritdoc/>
        public SampleOutcome Add(in JointSample sample)
        {
            if (IsBeyondSense(sample.Position)) Reset();
            var outcome = _history.Add(sample);
            if (outcome == SampleOutcome.Accepted) TakeNewest();
            else if (outcome == SampleOutcome.Late) Renew();
            return outcome;
        }

        /// <inheritdoc/>
        /// <remarks>It learns from what it is asked how far ahead it has to be good.</remarks>
        public JointPrediction At(double time)
        {
            if (_history.Count == 0) return default;
            var ahead = time - _history.NewestTime;
            _horizon.Ask(time, ahead);
            var kind = _connected < 2 || ahead > _limits.HorizonCap ? PredictionKind.Held
                : ahead <= 0 ? PredictionKind.Interpolated : PredictionKind.Predicted;
            var position = Hold + ForecastGrid.Read(_table, 0, Math.Min(ahead, _limits.HorizonCap));
            return new JointPrediction(_limits.Clamp(double.IsFinite(position) ? position : Hold), kind);
        }

        /// <inheritdoc/>
        public void Reset()
        {
            _history.Clear();
            _shocks.Reset();
            _standstill.Reset();
            _forecasters.Reset();
            _snapshots.Clear();
            _outliers.Reset();
            _overall.Reset(_prior);
            _moving.Reset(_prior);
            _resting.Reset(_prior);
            Array.Clear(_table, 0, _table.Length);
            _weights = _prior;
            _horizon.Reset();
            _greatestSquare = 1e-12;
            _start = 0;
        }

        void TakeNewest()
        {
            double interval = 0, speed = 0, intervalBefore = 0, speedBefore = 0;
            if (_history.Count >= 2)
            {
                (interval, speed) = Increment(0);
                _horizon.Sample(interval);
            }
            if (_history.Count >= 3) (intervalBefore, speedBefore) = Increment(1);
            _shocks.Add(_history.Count, interval, speed, intervalBefore, speedBefore);
            if (_history.Count >= 2 && (_history.Count == 2 || IsStart(speed, speedBefore))) _start = _history[1].Time;
            _standstill.Add(_history, interval);
            Score();
            _weights = Choose(speed);
            Forecast(_snapshots.Append());
        }

        // What overflows when it is squared would be remembered for ever.
        bool IsBeyondSense(double position)
        {
            var way = _history.Count == 0 ? position : position - Hold;
            return !(way * way < GreatestSquareOfSense);
        }

        (double Interval, double Speed) Increment(int age)
        {
            ref readonly var newer = ref _history[age];
            ref readonly var older = ref _history[age + 1];
            var interval = newer.Time - older.Time;
            return (interval, (newer.Position - older.Position) / interval);
        }

        static bool IsStart(double speed, double before) =>
            Math.Abs(before) < StartShare * Math.Abs(speed) || Math.Abs(speed) < StartShare * Math.Abs(before) || speed * before <= 0;

        // A sample that was overtaken changes what is displayed, but it taught the others' lesson already.
        void Renew()
        {
            if (_snapshots.Count > 0) Forecast(_snapshots[_snapshots.Count - 1]);
        }

        void Forecast(ForecastSnapshots.Snapshot into)
        {
            _connected = _history.CountWithoutGap(_limits.MaximumGap);
            _forecasters.Forecast(_history, _connected, _shocks.Available, _shocks.HasGrown, into.Tables);
            into.Time = _history.NewestTime;
            into.Position = _history.NewestPosition;
            into.Shocks = _shocks.Count;
            into.WasAtRest = _standstill.IsAtRest;
            for (var point = 0; point < ForecastGrid.Points; point++)
            {
                var sum = 0.0;
                for (var i = 0; i < Forecasters.Count; i++) sum += _weights[i] * into.Tables[i * ForecastGrid.Points + point];
                _table[point] = sum;
            }
            if (_connected < 2) return;
            var (interval, speed) = Increment(0);
            SpeedLimits.Apply(_table, speed, interval, _limits);
        }

        // The two snapshots whose age lies around the horizon share the lesson.
        void Score()
        {
            var now = _history.NewestTime;
            var older = _snapshots.Count - 1;
            while (older >= 0 && now - _snapshots[older].Time < _horizon.Seconds - Epsilon) older--;
            if (older < 0) return;
            var age = now - _snapshots[older].Time;
            var learned = false;
            if (older + 1 < _snapshots.Count)
            {
                var younger = now - _snapshots[older + 1].Time;
                var share = (_horizon.Seconds - younger) / (age - younger);
                learned |= Learn(_snapshots[older], share);
                learned |= Learn(_snapshots[older + 1], 1 - share);
            }
            else if (age < 1.5 * _horizon.Seconds + _horizon.Interval) learned = Learn(_snapshots[older], 1);
            _snapshots.Drop(older);
            if (!learned) return;

            var sampleShare = 1 - Math.Exp(-_horizon.Interval / Memory);
            _overall.Solve(PriorNow, sampleShare);
            _resting.Solve(_overall.Values, sampleShare);
            _moving.Solve(_overall.Values, sampleShare);
        }

        bool Learn(ForecastSnapshots.Snapshot snapshot, double share)
        {
            var ahead = _history.NewestTime - snapshot.Time;
            if (share < LeastShare || snapshot.Shocks != _shocks.Count || ahead > ForecastGrid.Span) return false;
            var square = ErrorsOf(snapshot, ahead);
            var keeping = Math.Exp(-_horizon.Interval * share / Memory);
            _greatestSquare = Math.Max(_greatestSquare * keeping, square);
            var isTelling = square > LeastShareOfSquare * _greatestSquare;
            if (isTelling) _overall.Learn(_errors, keeping);
            if (snapshot.WasAtRest) _resting.Learn(_errors, keeping);
            else if (isTelling) _moving.Learn(_errors, keeping);
            return isTelling || snapshot.WasAtRest;
        }

        double[] PriorNow => double.IsNaN(_history[0].Acceleration) ? _prior : _priorWhenTold;

        // Fills the errors, within what is credited; their square is that of hold, or of the mixture where that is greater.
        double ErrorsOf(ForecastSnapshots.Snapshot snapshot, double ahead)
        {
            var mixture = 0.0;
            for (var i = 0; i < Forecasters.Count; i++)
            {
                _errors[i] = ForecastGrid.Read(snapshot.Tables, i * ForecastGrid.Points, ahead) + snapshot.Position - Hold;
                mixture += _overall.Values[i] * _errors[i];
            }
            var greatest = Math.Max(Math.Abs(_errors[Forecasters.Hold]), Math.Abs(mixture));
            if (_overall.Evidence < LeastEvidence) return greatest * greatest;
            var bound = _outliers.Of(Math.Sqrt(_overall.MeanSquare(Forecasters.Hold)), greatest);
            for (var i = 0; i < Forecasters.Count; i++) _errors[i] = Math.Min(Math.Max(_errors[i], -bound), bound);
            return Math.Min(greatest, bound) * Math.Min(greatest, bound);
        }

        // What is far faster than anything scored meets weights learned from noise, or none: the first start would be lost.
        double[] Choose(double speed)
        {
            var heldSquare = _overall.MeanSquare(Forecasters.Hold);
            if (_standstill.IsAtRest) heldSquare = Math.Max(heldSquare, _resting.MeanSquare(Forecasters.Hold));
            var way = speed * _horizon.Seconds;
            if (_standstill.IsOnlyNoise) return _hold;
            if (way * way <= UnheardOf * heldSquare) return (_standstill.IsAtRest ? _resting : _moving).Values;
            var sinceStart = _history.NewestTime - _start;
            return sinceStart < Math.Max(StartSeconds, 1.01 * _horizon.Interval) + 1e-4 ? _line : PriorNow;
        }
    }
}
