using System;

namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// Recognises when the least delay of one direction changes, as when a headset roams to another access point, and keeps
    /// the bounds of that direction comparable across the change.
    /// </summary>
    /// <remarks>
    /// A longer least delay makes every bound of its direction late at once. Taken as they are, these bounds would move the
    /// offset by half the change and, while they replace the older ones, look like another skew. The clocks run on evenly,
    /// so the excess over the least delay known before is added to each bound, and offset and skew stay as they were proven.
    /// A delay that is shorter than any before replaces the reference, and the offset moves by half the difference.
    /// Either way the error is at most half the difference between the changes of both directions. A part that is too small to be told from
    /// a wrong skew moves the offset by half of it, and widens the error when the other direction shows that the path has changed.
    /// Allocates nothing once made.
    /// </remarks>
    sealed class LeastDelay
    {
        /// <summary>Changes below this, in s, stay with the fit: half of it is no error that matters.</summary>
        const double MinChange = 0.2e-3;

        /// <summary>Exchanges before the change that give the level known before: 40 s at five a second.</summary>
        const int MaxEarlier = 200;

        const int MinEarlier = 60;

        /// <summary>
        /// Length of a window at least, and of one whose delays scatter more than before: a queue in a busy network makes every
        /// packet late too, by more unequal amounts, and is gone in less than the longer time.
        /// </summary>
        static readonly TimeSpan MinDuration = TimeSpan.FromSeconds(6), MinDurationScattered = TimeSpan.FromSeconds(30);

        /// <summary>
        /// Share by which the median lateness of a window may exceed that of the exchanges before, times the root of the window's length. Above
        /// it, delays count as scattered more. About two standard errors of the median of exponential delays.
        /// </summary>
        const double MaxScatterGrowth = 3;

        /// <summary>
        /// Lengths of the windows in which every bound must be late, more where these are less than the least duration. A quiet direction
        /// shows a change in the first, a noisy one needs the last.
        /// </summary>
        static readonly int[] Windows = { 30, 60, 105, 150, 210, 300, MaxWindow };

        /// <summary>90 s at five exchanges a second.</summary>
        const int MaxWindow = 450;

        /// <summary>
        /// The oldest of so many parts of a window does not tell how large a change is: it may hold a late exchange from before.
        /// </summary>
        const int BoundaryShare = 6;

        /// <summary>A window is late by chance with a probability of exp(−this), were the delays independent.</summary>
        const double Significance = 20;

        /// <summary>The same once the other direction has changed: a change is likely then.</summary>
        const double ExpectedSignificance = 7;

        /// <summary>The same for the part of a change that may be hidden: it only widens the error.</summary>
        const double HiddenSignificance = 3;

        /// <summary>
        /// Exchanges in which a shorter delay shows, and how many of them must show it. A step of a clock is found within as
        /// many, see <see cref="OffsetShiftWatch"/>.
        /// </summary>
        const int ShorterWindow = 32, ShorterCount = 3, StepWindow = 16;

        /// <summary>How much shorter a delay must be, in median latenesses divided by the number of earlier exchanges.</summary>
        const double LatenessShare = 15;

        /// <summary>
        /// Standard errors of the skew by which the bounds before a change may seem shifted. Fewer for a longer delay, as the round trips
        /// show it too.
        /// </summary>
        const double SkewErrorsLonger = 1, SkewErrorsShorter = 1.5;

        readonly int _sign;
        readonly BoundsHistory _history;
        readonly double[] _tightness = new double[MaxWindow + MaxEarlier];
        readonly double[] _shorter = new double[ShorterWindow];
        readonly double[] _lateness = new double[MaxWindow + MaxEarlier];
        double _excess, _excessError, _referenceError, _hiddenError;
        int _count, _sinceChange, _sinceHidden, _sinceShorter, _looks;

        /// <param name="sign">1 for the bounds below the offset, which requests give; −1 for those above, which replies give.</param>
        public LeastDelay(int sign, BoundsHistory history)
        {
            _sign = sign;
            _history = history;
        }

        /// <summary>How much longer the least delay is than the least one known, s; zero or more.</summary>
        public double Excess => _excess;

        /// <summary>How well the corrections are known, s.</summary>
        public double Error => _excessError + _referenceError + _hiddenError;

        public void Reset()
        {
            _excess = _excessError = _referenceError = _hiddenError = 0;
            _sinceChange = _sinceShorter = _looks = 0;
        }

        /// <summary>Measures the bounds of the history along a curve. The newest has been corrected by <see cref="Excess"/>.</summary>
        /// <param name="curve">Runs as the offset does; its height does not matter.</param>
        public void Measure(OffsetCurve curve)
        {
            _count = Math.Min(_history.Count, _tightness.Length);
            for (var i = 0; i < _count; i++) _tightness[i] = Tightness(i, curve);
        }

        /// <summary>Looks for a change in the bounds that were measured.</summary>
        /// <param name="other">The other direction, measured along the same curve.</param>
        /// <param name="skewError">One standard error of the curve's slope.</param>
        /// <param name="resolution">Of the control clock, s: so far bounds move without any change.</param>
        /// <returns>Whether a change was recognised.</returns>
        public bool Update(LeastDelay other, double skewError, double resolution)
        {
            _sinceChange++;
            _sinceHidden++;
            if (_count < MinEarlier + ShorterWindow) return false;
            if (_excess > 0) FollowShorterAgain(_count);
            if (_sinceShorter > 0) FollowShorter(_count);
            return FindLonger(other, _count, skewError, resolution) || FindShorter(_count, skewError, resolution);
        }

        // How late the most punctual bound of a window is; negative where it proves more than the earlier ones.
        double Lateness(int window, int earlier) => Max(window, earlier) - Max(0, window);

        double Tightness(int age, OffsetCurve curve)
        {
            ref readonly var bounds = ref _history[age];
            var (at, bound) = _sign > 0 ? (bounds.Sent, bounds.Least) : (bounds.Received, bounds.Greatest);
            var (newestAt, newest) = _sign > 0 ? (_history[0].Sent, _history[0].Least) : (_history[0].Received, _history[0].Greatest);
            return _sign * (ClockTicks.Seconds(new TimeSpan(bound - newest)) - curve.At(ClockTicks.Seconds(at - newestAt)));
        }

        // A bound that is corrected by too much would prove more than it does.
        void FollowShorterAgain(int count)
        {
            var broken = Math.Min(_excess, _tightness[0] - Max(1, count));
            if (broken <= 0) return;
            // What is left then is the lateness of single exchanges.
            if (_excess - broken < MinChange / 2) broken = _excess;
            // A little: the excess was never as large. Much: the path has changed again with this exchange.
            var isEstimate = broken < 3 * _excessError;
            Shift(0, isEstimate ? Math.Min(_sinceChange, count) : 1, -broken);
            _excessError *= 1 - broken / _excess;
            _excess -= broken;
            if (!isEstimate) _sinceChange = 1;
        }

        bool FindLonger(LeastDelay other, int count, double skewError, double resolution)
        {
            // A path that has changed in one direction has probably changed in both, by unequal amounts.
            var isExpected = other._excess > 0 && other._sinceChange <= MaxWindow;
            var minChange = isExpected ? MinChange / 2 : MinChange;
            var significance = isExpected ? ExpectedSignificance : Significance;
            foreach (var least in Windows)
            {
                var window = least;
                while (window < Math.Min(MaxWindow, count) && Duration(window) < MinDuration) window++;
                if (count < window + MinEarlier) return false;
                var duration = Duration(window);
                if (duration < MinDuration) continue;
                var earlier = Math.Min(count, window + MaxEarlier);
                var reference = Max(window, earlier);
                var late = reference - Max(0, window);
                var change = reference - Max(0, window - window / BoundaryShare);
                if (late <= Margin(earlier, minChange, SkewErrorsLonger * skewError, resolution)) continue;
                // A wrong skew makes one direction late by as much as the other proves more. The least round trip then stays as it was.
                if (late + Math.Min(0, other.Lateness(window, earlier)) <= minChange + resolution) continue;
                if (late <= Quantile(window, earlier, reference, 1 - Math.Exp(-significance / window))) continue;
                var typicalSince = Quantile(0, window, reference - change, 0.5);
                var typical = Quantile(window, earlier, reference, 0.5);
                if (!isExpected && typicalSince > (1 + MaxScatterGrowth / Math.Sqrt(window)) * typical && duration < MinDurationScattered) continue;
                _excessError += typical / (earlier - window) + typicalSince / window;
                _excess += change;
                _sinceChange = window;
                if (_sinceHidden < window) _hiddenError = 0;
                other.Hide(window, earlier);
                for (var i = 0; i < window; i++) Shift(i, i + 1, Math.Min(change, reference - _tightness[i]));
                return true;
            }
            return false;
        }

        // The other direction may have changed too, by less than can be told from a wrong skew. The offset then moves by half of that.
        void Hide(int window, int earlier)
        {
            var late = Math.Abs(Lateness(window, earlier));
            if (late <= Quantile(window, earlier, Max(window, earlier), 1 - Math.Exp(-HiddenSignificance / window))) return;
            _hiddenError += late / 2;
            _sinceHidden = 0;
        }

        // After a few exchanges the new least delay is known less well than the one before, and a bound that proves more shows a larger change.
        void FollowShorter(int count)
        {
            if (++_sinceShorter > Math.Min(count, MaxEarlier)) _sinceShorter = 0;
            if (_sinceShorter == 0) return;
            var more = _tightness[0] - Max(1, _sinceShorter);
            if (more <= 0) return;
            Shift(_sinceShorter, _history.Count, more);
            _referenceError += more / 2;
        }

        // Until it is certain, a bound that proves more than those before is taken as if it proved as much: what follows is a change of the
        // offset, never one of the skew.
        bool FindShorter(int count, double skewError, double resolution)
        {
            var earlier = Math.Min(count, ShorterWindow + MaxEarlier);
            // Without the recent ones: several that prove a little more each would hide the change.
            var reference = Max(ShorterWindow, earlier);
            var shorter = _tightness[0] - reference;
            int times = 0, first = 0;
            _shorter[_looks++ % ShorterWindow] = 0;
            for (var age = 1; age < Math.Min(_looks, ShorterWindow); age++)
                if (Withheld(age) > 0) (times, first) = (times + 1, age);
            // Any amount confirms a bound that has exceeded the margin.
            var margin = times > 0 ? 0 : Math.Max(
                Margin(earlier, MinChange, SkewErrorsShorter * skewError, resolution),
                LatenessShare * Quantile(ShorterWindow, earlier, reference, 0.5) / (earlier - ShorterWindow));
            if (shorter <= margin) return false;
            _shorter[(_looks - 1) % ShorterWindow] = shorter;
            Shift(0, 1, -shorter);
            // Until then it may be a step.
            if (times + 1 < ShorterCount || first < StepWindow - 1) return false;
            for (var age = 0; age <= first; age++) Shift(age, age + 1, Withheld(age));
            _sinceShorter = first + 1;
            // Bounds that proved more by less than the margin, just before, belong to the shorter path too.
            for (var age = first + 1; age < ShorterWindow; age++)
                if (_tightness[age] > Max(age + 1, earlier)) _sinceShorter = age + 1;
            var change = Max(0, _sinceShorter) - Max(_sinceShorter, earlier);
            Shift(_sinceShorter, _history.Count, change);
            _referenceError += change / 2;
            _looks = 0;
            return true;
        }

        // How much more a bound proved than was taken from it.
        double Withheld(int age) => _shorter[(_looks - 1 - age) % ShorterWindow];

        TimeSpan Duration(int exchanges) => _history[0].Received - _history[exchanges - 1].Received;

        double Margin(int earlier, double minChange, double skewError, double resolution) =>
            minChange + resolution + skewError * ClockTicks.Seconds(Duration(earlier));

        // Of the lateness behind the reference.
        double Quantile(int from, int to, double reference, double share)
        {
            for (var i = from; i < to; i++) _lateness[i - from] = reference - _tightness[i];
            Array.Sort(_lateness, 0, to - from);
            return _lateness[(int)Math.Ceiling(share * (to - from - 1))];
        }

        double Max(int from, int to)
        {
            var max = double.NegativeInfinity;
            for (var i = from; i < to; i++) max = Math.Max(max, _tightness[i]);
            return max;
        }

        void Shift(int from, int to, double seconds)
        {
            var ticks = ClockTicks.Span(seconds).Ticks * _sign;
            for (var i = from; i < to; i++)
                _history.Shift(i, _sign > 0 ? ticks : 0, _sign > 0 ? 0 : ticks);
            for (var i = from; i < Math.Min(to, _tightness.Length); i++) _tightness[i] += seconds;
        }
    }
}
