using System;

namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// Estimates the error of the offset due to a change of the path that is not recognised yet, or that is too small to be recognised in
    /// the scatter of the delays. Allocates nothing after construction.
    /// </summary>
    /// <remarks>
    /// The tightest bounds of the newest exchanges are compared with the tightest bounds of all earlier exchanges, for every time at which the path
    /// may have changed. The sum of the changes in both directions is the change of the minimum round-trip time, on which a wrong skew has little
    /// effect. The fit allows for a step of the delays at the most probable time, which reduces the effect of the change on offset and skew. The
    /// offset follows a longer path in proportion to the weight of the exchanges since the change. If the path has become shorter, the offset was
    /// wrong by half of the change.
    /// </remarks>
    sealed class UnrecognisedChange
    {
        /// <summary>Number of exchanges in a block. A change is assumed to lie between two blocks.</summary>
        const int Block = 30;

        /// <summary>Minimum number of blocks before a change.</summary>
        const int MinEarlier = 2;

        /// <summary>
        /// Lateness that is attributed to scatter, as a multiple of the mean lateness. For exponential delays, it is 1.4 standard deviations above
        /// the mean.
        /// </summary>
        const double UsualFactor = 2;

        /// <summary>
        /// Conditions for an error that is remembered after the last exchange before the change has left the history. RememberedFactor: minimum
        /// lateness of a longer path, as a multiple of the mean lateness. MinRemembered: minimum number of blocks that show it. With exponential
        /// delays, scatter alone exceeds this limit with a probability of 5·10⁻⁴ in each window.
        /// </summary>
        const double RememberedFactor = 5;
        const int MinRemembered = 10;

        /// <summary>
        /// Conditions for a probable change. ProbableFactor: minimum lateness of a longer path, as a multiple of the mean lateness. MinProbable:
        /// minimum number of blocks that show it. The errors are the same with factors from 3 to 6; with 8, changes of 0.5 ms move the offset
        /// further. A queue also makes packets late, but for less than 30 s at five exchanges per second. With a smaller number of blocks, the
        /// largest error under load would increase from 0.24 to 1.6 ms.
        /// </summary>
        const double ProbableFactor = 4.5;
        const int MinProbable = 5;

        readonly EnvelopeSide _below, _above;
        readonly BoundsHistory _history;
        readonly double[] _tightest = new double[MinDelay.MaxCount / Block];
        readonly double[] _late = new double[MinDelay.MaxCount / Block];
        double _usual, _remembered;
        // Time of the earliest change that the remembered error includes.
        HeadsetTime _rememberedAt;

        public UnrecognisedChange(EnvelopeSide below, EnvelopeSide above, BoundsHistory history) =>
            (_below, _above, _history) = (below, above, history);

        /// <summary>Discards the remembered error, because the estimate restarts.</summary>
        public void Reset() => _remembered = ProbableChange = 0;

        /// <summary>Increase of the minimum round-trip time at the most probable time of a change, s; 0 if scatter explains the delays.</summary>
        public double ProbableChange { get; private set; }

        /// <summary>Time of <see cref="ProbableChange"/>.</summary>
        public HeadsetTime ProbableAt { get; private set; }

        /// <summary>
        /// Discards the remembered error if it belongs to the change of the path that was recognised and corrected. The error of an earlier
        /// change remains, because that change may have left the history.
        /// </summary>
        /// <param name="since">Number of exchanges since the recognised change. The remembered time is accurate to a block.</param>
        public void Explain(int since)
        {
            if (_rememberedAt >= SentAt(since + Block)) _remembered = 0;
        }

        /// <summary>Returns the maximum error over all possible times of a change, s.</summary>
        /// <param name="up">Delays of the requests, measured up to the newest exchange.</param>
        /// <param name="down">Delays of the replies, measured up to the newest exchange.</param>
        public double Error(MinDelay up, MinDelay down)
        {
            var blocks = up.Count / Block;
            Array.Clear(_late, 0, blocks);
            _usual = 0;
            AddLateness(up, blocks);
            AddLateness(down, blocks);
            var (error, clearest) = (0.0, 0.0);
            ProbableChange = 0;
            for (var newest = 1; newest <= blocks - MinEarlier; newest++)
            {
                var late = _late[newest - 1];
                // The usual lateness of a tightest bound is inversely proportional to the number of packets among which it is the tightest.
                var longer = late - UsualFactor * _usual / newest;
                var shorter = -late - UsualFactor * _usual / (blocks - newest);
                if (newest >= MinRemembered && late > RememberedFactor * _usual / newest) Remember(late / 2, SentAt(newest * Block));
                var beyond = late * newest - ProbableFactor * _usual;
                if (newest >= MinProbable && beyond > clearest)
                    (clearest, ProbableChange, ProbableAt) = (beyond, late, SentAt(newest * Block));
                // The offset moves by at most two thirds of a change, so a change below the error has no effect.
                if (longer > error) error = Math.Max(error, longer * Followed((newest + 1) * Block));
                error = Math.Max(error, shorter / 2);
            }
            return Math.Max(error, _remembered);
        }

        void Remember(double error, HeadsetTime at)
        {
            if (_remembered == 0 || at < _rememberedAt) _rememberedAt = at;
            _remembered = Math.Max(_remembered, error);
        }

        HeadsetTime SentAt(int exchanges) => _history[Math.Min(exchanges, _history.Count) - 1].Sent;

        // Adds the lateness of the newest blocks relative to all earlier blocks, and the usual lateness of a single block.
        void AddLateness(MinDelay delay, int blocks)
        {
            var newest = double.NegativeInfinity;
            for (var i = 0; i < blocks; i++) _tightest[i] = delay.Tightest(i * Block, (i + 1) * Block);
            for (var i = 0; i < blocks; i++)
            {
                newest = Math.Max(newest, _tightest[i]);
                _late[i] -= newest;
            }
            var earlier = double.NegativeInfinity;
            var sum = 0.0;
            for (var i = blocks - 1; i >= 0; i--)
            {
                _late[i] += earlier;
                earlier = Math.Max(earlier, _tightest[i]);
                sum += _tightest[i];
            }
            if (blocks > 0) _usual += earlier - sum / blocks;
        }

        // Returns the movement of the offset as a fraction of a change, if the change occurred immediately before the given number of newest
        // exchanges. If the newest fraction f of one side's points is shifted by a step, a line fitted to both sides moves at its end by f/2 + 3f(1
        // − f)/2 of the step.
        double Followed(int newest)
        {
            var since = ClockTicks.Seconds(SentAt(newest) - _history[0].Received);
            var share = (_below.WeightShareSince(since) + _above.WeightShareSince(since)) / 2;
            return share / 2 + 1.5 * share * (1 - share);
        }
    }
}
